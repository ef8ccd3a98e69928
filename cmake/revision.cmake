# Writes the version, the git revision and whether the tree differs from it; the file is touched only when that changes. An unpacked
# source archive has no .git, but a file REVISION in which git archive wrote the revision. Nothing tells whether it was changed.
set(revision "")
set(changes "")
if(EXISTS ${SOURCE_DIR}/.git) # another repository may be around the source
  execute_process(COMMAND git -C ${SOURCE_DIR} rev-parse HEAD
                  OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND git -C ${SOURCE_DIR} status --porcelain --untracked-files=no
                  OUTPUT_VARIABLE changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
elseif(EXISTS ${SOURCE_DIR}/REVISION)
  file(STRINGS ${SOURCE_DIR}/REVISION revision LIMIT_COUNT 1)
endif()
if(NOT revision MATCHES "^[0-9a-f]+$")
  set(revision "unknown")
endif()
if(changes STREQUAL "")
  set(dirty false)
else()
  set(dirty true)
endif()
string(RANDOM LENGTH 8 suffix)
file(WRITE ${OUTPUT}.${suffix} "#define CONTINUA_VERSION \"${VERSION}\"\n#define CONTINUA_REVISION \"${revision}\"\n#define CONTINUA_DIRTY ${dirty}\n")
execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different ${OUTPUT}.${suffix} ${OUTPUT})
file(REMOVE ${OUTPUT}.${suffix})
