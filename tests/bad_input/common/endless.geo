x = 0;
For i In {1 : 1e12}
  x += 1;
EndFor
