# SPDX-License-Identifier: Apache-2.0
# cmake --install: the program, the library with its package, the manual page, bash completion.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gonio)
set(package_version ${CMAKE_BINARY_DIR}/gonioConfigVersion.cmake)
write_basic_package_version_file(${package_version} COMPATIBILITY SameMinorVersion)

install(TARGETS gonio_host EXPORT gonioTargets)
install(EXPORT gonioTargets NAMESPACE gonio:: DESTINATION ${package_dir})
install(FILES host/cmake/gonioConfig.cmake ${package_version} DESTINATION ${package_dir})
install(DIRECTORY include/gonio DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(TARGETS gonio)
install(FILES host/completion.bash RENAME gonio
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
find_program(HELP2MAN help2man)
if(HELP2MAN)
  add_custom_command(OUTPUT gonio.1 DEPENDS gonio VERBATIM
    COMMAND ${HELP2MAN} --no-info --name=${PROJECT_DESCRIPTION} --output=gonio.1
            $<TARGET_FILE:gonio>)
  add_custom_target(gonio_manual ALL DEPENDS gonio.1)
  install(FILES ${CMAKE_BINARY_DIR}/gonio.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
