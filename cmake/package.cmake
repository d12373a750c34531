# The program as a Debian package: `cpack` in the build folder.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME snug)
set(CPACK_PACKAGE_CONTACT "The Snug maintainers <maintainers@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "design protective foam from 3D models")
set(CPACK_PACKAGE_DESCRIPTION
    "From 3D models or scans Snug makes pieces of foam that fill the space between them and their case, in blocks that real\nfoam has, and the files to make them: maps for sponge, outlines for sheets, solids for printers, programs for mills.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME snug)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# For pages in Japanese.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS fonts-ipafont-gothic)
set(CPACK_OUTPUT_FILE_PREFIX ${CMAKE_BINARY_DIR}/package)
include(CPack)
