/* SystemCall "in a comment";
   is none */
// SystemCall "neither is this";
text = "SystemCall in a text";
SystemCall "touch continua-was-here";
Merge "two-regions.geo";
