# What is installed, and the Debian package: scripts/build/package.
include(GNUInstallDirs)
install(TARGETS continua RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY parameter_files DESTINATION share/continua)
install(FILES scripts/completion/continua DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)

# The scripts that draw, with what they share, and commands that call them from anywhere and from any prefix.
set(CONTINUA_SCRIPTS plot plot-comparison plot-refinement report editor-support)
foreach(script ${CONTINUA_SCRIPTS})
  install(PROGRAMS scripts/${script} DESTINATION share/continua/scripts)
  set(command ${CMAKE_CURRENT_BINARY_DIR}/commands/continua-${script})
  file(WRITE ${command}.in "#!/bin/sh\nexec \"$(dirname \"$(readlink -f \"$0\")\")/../share/continua/scripts/${script}\" \"$@\"\n")
  configure_file(${command}.in ${command} COPYONLY FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
                 GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  install(PROGRAMS ${command} DESTINATION ${CMAKE_INSTALL_BINDIR})
endforeach()
install(DIRECTORY scripts/lib DESTINATION share/continua/scripts
        FILES_MATCHING PATTERN "*.py" PATTERN "report/*.js" PATTERN "report/*.css" PATTERN "thesis" EXCLUDE)
# What scripts/build/report-assets has brought before, if anything: without it the curves of a report are pictures.
install(DIRECTORY ${CMAKE_BINARY_DIR}/../report-assets/ DESTINATION share/continua/scripts/lib/report/assets OPTIONAL)

# The Python package, where Debian's python3 looks in /usr; below another prefix PYTHONPATH names the folder. The scripts find it
# beside what they share, as in the checkout.
set(CONTINUA_PYTHON_FOLDER lib/python3/dist-packages CACHE STRING "Folder of Python packages, from the prefix")
install(DIRECTORY python/continua DESTINATION ${CONTINUA_PYTHON_FOLDER} FILES_MATCHING PATTERN "*.py")
install(FILES VERSION DESTINATION ${CONTINUA_PYTHON_FOLDER}/continua)
install(CODE "file(CREATE_LINK ../../../../${CONTINUA_PYTHON_FOLDER}/continua
  \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share/continua/scripts/lib/continua\" SYMBOLIC)")

# Debian wants manual pages compressed.
configure_file(doc/continua.1.in ${CMAKE_CURRENT_BINARY_DIR}/continua.1 @ONLY)
find_program(GZIP_EXECUTABLE gzip)
if(GZIP_EXECUTABLE)
  execute_process(COMMAND ${GZIP_EXECUTABLE} -9nf ${CMAKE_CURRENT_BINARY_DIR}/continua.1)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/continua.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
else()
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/continua.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME continua)
set(CPACK_PACKAGE_VENDOR "The Continua authors")
set(CPACK_PACKAGE_CONTACT "The Continua authors <continua@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "fluid-structure interaction with a single solution")
set(CPACK_PACKAGE_DESCRIPTION "Fluid and solid are one continuum with one set of equations for velocity and pressure, on one mesh.
For waves in liquid-filled flexible tubes and vessels, flows, and vibrating elastic and viscoelastic bodies; with the exact wave
theory beside the runs.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# Each Debian has other libraries. Its number is therefore in the version and in the file name (0.1.0-deb12), and apt takes the package
# for Debian 13 when a system goes from Debian 12 to 13.
if(EXISTS /etc/os-release)
  file(STRINGS /etc/os-release CONTINUA_OS REGEX "^(ID|VERSION_ID)=")
  if("${CONTINUA_OS}" MATCHES "(^|;)ID=debian(;|$)" AND "${CONTINUA_OS}" MATCHES "VERSION_ID=\"?([0-9]+)")
    set(CPACK_DEBIAN_PACKAGE_RELEASE deb${CMAKE_MATCH_1})
  endif()
endif()
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# The libraries, from the program itself; the rest is what runs and pictures need.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "openmpi-bin, python3, python3-matplotlib, python3-numpy, python3-pandas, python3-xarray")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, python3-vtk9, xauth, xvfb")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview, gmsh")
include(CPack)
