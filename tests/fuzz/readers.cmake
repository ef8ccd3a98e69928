# The readers that are given inputs by chance, each of which has a file NAME.cc here and inputs in corpus/NAME, and the sources
# that they need. Two projects use the list: the fuzzers of scripts/attack/fuzz, and the suite, which reads the corpus.
set(continua_readers parameter_text units csv_table gmsh_file archive)
set(continua_reader_sources base/archive base/atomic_file base/csv_table base/input_error base/input_file base/nearest_name base/parameter_text base/table_cells
    base/quoted_name base/units mesh/gmsh_file)
