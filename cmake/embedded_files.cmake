# Writes FILES as entries of a table to OUTPUT, {"NAME", R"...(TEXT)..."}, sorted by name: an EmbeddedFile each.
list(SORT FILES)
set(table "")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND table "{\"${name}\",\nR\"EMBEDDED(${text})EMBEDDED\"},\n")
endforeach()
file(WRITE ${OUTPUT} "${table}")
