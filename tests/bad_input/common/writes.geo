x = 1;
Printf("%g (%g)", Sin(x), x) >> "continua-was-here";
