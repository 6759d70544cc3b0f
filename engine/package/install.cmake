# SPDX-License-Identifier: MIT
# Install rules of the engine. Components: kodo-dev (headers, static libraries, CMake and pkg-config
# files), kodo-runtime (shared libraries), kodo-c and kodo-c-dev (see c/), kodo-python (see python/),
# kodo-sfml-dev (see sfml/), apart (see game/).
include(CMakePackageConfigHelpers)

# kodo_install_pkg_config(NAME DESCRIPTION text LIBRARY name [REQUIRES list] [CFLAGS flag]
# [PRIVATE flag] [COMPONENT name]): NAME.pc, in the component kodo-dev or another one. Its paths are
# relative to itself, so an installed tree may be moved.
function(kodo_install_pkg_config name)
    cmake_parse_arguments(arg "" "DESCRIPTION;LIBRARY;REQUIRES;CFLAGS;PRIVATE;COMPONENT" "" ${ARGN})
    if(NOT arg_COMPONENT)
        set(arg_COMPONENT kodo-dev)
    endif()
    file(RELATIVE_PATH up_to_prefix
        ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX}/.)
    string(REGEX REPLACE "/$" "" up_to_prefix ${up_to_prefix})
    foreach(path IN ITEMS includedir libdir)
        string(TOUPPER ${path} upper)
        set(${path} "\${prefix}")
        cmake_path(APPEND ${path} ${CMAKE_INSTALL_${upper}}) # an absolute one replaces the prefix
    endforeach()
    configure_file(${PROJECT_SOURCE_DIR}/engine/package/kodo.pc.in
        ${PROJECT_BINARY_DIR}/package/${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/package/${name}.pc COMPONENT ${arg_COMPONENT}
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

install(TARGETS ${kodo_libraries} EXPORT kodo-targets
    ARCHIVE COMPONENT kodo-dev
    RUNTIME COMPONENT kodo-runtime
    LIBRARY COMPONENT kodo-runtime NAMELINK_COMPONENT kodo-dev)
if(kodo_seal AND KODO_TESTS)
    list(JOIN kodo_seal "\" \"" kodo_seal_words)
    foreach(library IN LISTS kodo_libraries)
        install(CODE "
            set(archive \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}\")
            execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND \"${CMAKE_COMMAND}\"
                \"-DARCHIVE=\${archive}/$<TARGET_FILE_NAME:${library}>\" \"${kodo_seal_words}\")"
            COMPONENT kodo-dev)
    endforeach()
endif()
install(DIRECTORY include/kodo TYPE INCLUDE COMPONENT kodo-dev)
install(FILES ${PROJECT_BINARY_DIR}/include/kodo/export.hpp COMPONENT kodo-dev
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/kodo)

set(kodo_cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/kodo)
configure_package_config_file(package/kodo-config.cmake.in
    ${PROJECT_BINARY_DIR}/package/kodo-config.cmake
    INSTALL_DESTINATION ${kodo_cmake_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/kodo-config-version.cmake
    VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES
        ${PROJECT_BINARY_DIR}/package/kodo-config.cmake
        ${PROJECT_BINARY_DIR}/package/kodo-config-version.cmake
    DESTINATION ${kodo_cmake_folder} COMPONENT kodo-dev)
install(EXPORT kodo-targets NAMESPACE kodo:: DESTINATION ${kodo_cmake_folder} COMPONENT kodo-dev)

kodo_install_pkg_config(kodo LIBRARY kodo PRIVATE -pthread CFLAGS -std=c++20
    DESCRIPTION "2D rigid-body engine, single precision")
if(KODO_DOUBLE)
    kodo_install_pkg_config(kodo64 LIBRARY kodo64 PRIVATE -pthread
        CFLAGS "-std=c++20 -DKODO_DOUBLE" DESCRIPTION "2D rigid-body engine, double precision")
endif()

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE COMPONENT kodo-dev
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kodo)
install(FILES CHANGELOG.md README.md COMPONENT kodo-dev DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kodo)
# The pages, their pictures and the examples lie beside each other as in the sources, so that links
# between them hold.
install(DIRECTORY docs examples c python COMPONENT kodo-dev
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kodo
    FILES_MATCHING PATTERN *.md PATTERN *.svg PATTERN *.cpp PATTERN *.c PATTERN *.py PATTERN *.txt
    PATTERN CMakeLists.txt EXCLUDE PATTERN kodo_c EXCLUDE PATTERN python/kodo EXCLUDE)
if(KODO_C)
    set(kodo_c_documents ${CMAKE_INSTALL_DATADIR}/doc/kodo-c)
    install(TARGETS ${kodo_c_libraries} EXPORT kodo-c-targets
        ARCHIVE COMPONENT kodo-c-dev # import libraries of Windows
        RUNTIME COMPONENT kodo-c
        LIBRARY COMPONENT kodo-c NAMELINK_COMPONENT kodo-c-dev)
    install(FILES c/kodo.h TYPE INCLUDE COMPONENT kodo-c-dev)
    install(EXPORT kodo-c-targets NAMESPACE kodo:: DESTINATION ${kodo_cmake_folder}
        COMPONENT kodo-c-dev)
    kodo_install_pkg_config(kodo_c LIBRARY kodo_c COMPONENT kodo-c-dev
        DESCRIPTION "2D rigid-body engine, C interface, single precision")
    if(KODO_DOUBLE)
        kodo_install_pkg_config(kodo_c64 LIBRARY kodo_c64 CFLAGS -DKODO_DOUBLE COMPONENT kodo-c-dev
            DESCRIPTION "2D rigid-body engine, C interface, double precision")
    endif()
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE COMPONENT kodo-c DESTINATION ${kodo_c_documents})
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE COMPONENT kodo-c-dev
        DESTINATION ${kodo_c_documents}-dev)
    install(DIRECTORY python/kodo DESTINATION lib/python3/dist-packages COMPONENT kodo-python
        FILES_MATCHING PATTERN *.py PATTERN py.typed)
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE COMPONENT kodo-python
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kodo-python)
endif()
if(BUILD_SHARED_LIBS)
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE COMPONENT kodo-runtime
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kodo-runtime)
endif()
