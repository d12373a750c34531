# What `cmake --install` leaves, in two components: the program, and the library for programs of others.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The program, with its manual page and what shells complete it by, which it says itself.
set(pages ${CMAKE_BINARY_DIR}/pages)
set(made "")
# snug_page(DESTINATION NAME ARGUMENT...): a file that `snug generate` prints.
function(snug_page destination name)
    set(page ${pages}/${destination}/${name})
    cmake_path(GET page PARENT_PATH folder)
    add_custom_command(OUTPUT ${page}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
        COMMAND snug_program generate ${ARGN} > ${page}
        DEPENDS snug_program VERBATIM)
    install(FILES ${page} DESTINATION ${destination} COMPONENT program)
    set(made ${made} ${page} PARENT_SCOPE)
endfunction()
snug_page(${CMAKE_INSTALL_MANDIR}/man1 snug.1 man)
snug_page(${CMAKE_INSTALL_MANDIR}/ja/man1 snug.1 man --language ja)
snug_page(${CMAKE_INSTALL_DATADIR}/bash-completion/completions snug bash)
snug_page(${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions _snug zsh)
snug_page(${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d snug.fish fish)
if(NOT SNUG_SANITIZE)  # which is for tests, and says the same
    add_custom_target(snug_pages ALL DEPENDS ${made})
endif()
install(TARGETS snug_program DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
# Where `snug studio` looks for it; where it was not built, that command says so.
install(DIRECTORY studio/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/snug/studio COMPONENT program OPTIONAL)
install(FILES CHANGELOG.md docs/options.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)

# The library, as find_package(snug) finds it: snug::snug, its headers as snug/... .
set_target_properties(snug_library PROPERTIES EXPORT_NAME snug)
target_compile_features(snug_library PUBLIC cxx_std_20)
# Of inline functions the linker takes any one copy, and all must give the same bits.
target_compile_options(snug_library INTERFACE $<INSTALL_INTERFACE:-ffp-contract=off>)
install(TARGETS snug_library EXPORT snug DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY snug DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library FILES_MATCHING PATTERN *.h)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/snug)
install(EXPORT snug NAMESPACE snug:: FILE snugTargets.cmake DESTINATION ${config_folder} COMPONENT library)
configure_package_config_file(cmake/snugConfig.cmake.in ${CMAKE_BINARY_DIR}/snugConfig.cmake
    INSTALL_DESTINATION ${config_folder} NO_SET_AND_CHECK_MACRO)
# Before 1.0 a new minor version may break what uses it.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/snugConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/snugConfig.cmake ${CMAKE_BINARY_DIR}/snugConfigVersion.cmake
        DESTINATION ${config_folder} COMPONENT library)
