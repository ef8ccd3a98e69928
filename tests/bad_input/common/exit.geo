Merge "two-regions.geo";
Exit;
