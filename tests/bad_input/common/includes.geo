Include "writes.geo";
