# The sets of wide instructions for which products without a matrix are compiled: continua_wide_sets, the options of each in
# options_of_SET, from CONTINUA_INSTRUCTIONS.
set(options_of_avx2 -mavx2 -mfma)
# GCC 12's own headers warn.
set(options_of_avx512 -mavx512f -mavx512dq -mavx512bw -mavx512vl -mfma
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>" "$<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized>")

set(continua_wide_sets)
if(NOT CONTINUA_INSTRUCTIONS MATCHES "^(native|all|baseline)$")
  message(FATAL_ERROR "CONTINUA_INSTRUCTIONS is '${CONTINUA_INSTRUCTIONS}': it must be native, all or baseline")
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  if(CONTINUA_INSTRUCTIONS STREQUAL "all")
    set(continua_wide_sets avx2 avx512)
  elseif(CONTINUA_INSTRUCTIONS STREQUAL "native" AND EXISTS /proc/cpuinfo)
    file(STRINGS /proc/cpuinfo flags REGEX "^flags" LIMIT_COUNT 1)
    # As can_run() in base/instruction_set.cc.
    if(flags MATCHES " avx512f " AND flags MATCHES " avx512dq " AND flags MATCHES " avx512bw " AND flags MATCHES " avx512vl")
      set(continua_wide_sets avx512)
    elseif(flags MATCHES " avx2 " AND flags MATCHES " fma ")
      set(continua_wide_sets avx2)
    endif()
  endif()
endif()

# In a file, so that another choice compiles again what depends on it alone.
set(text "")
foreach(set ${continua_wide_sets})
  string(TOUPPER ${set} upper_case)
  string(APPEND text "#define CONTINUA_${upper_case}\n")
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/generated/continua/base/instructions.inc CONTENT "${text}")
