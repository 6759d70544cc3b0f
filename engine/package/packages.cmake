# SPDX-License-Identifier: MIT
# Packages: `cpack` in the build folder. A TGZ holds a whole prefix and works where it is unpacked;
# each DEB holds one component.
set(CPACK_PACKAGE_NAME kodo)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "The Kodo authors")
set(CPACK_PACKAGE_CONTACT "The Kodo authors <kodo@example.org>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS # whatever the umask is
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/cpack_options.cmake)
set(CPACK_GENERATOR TGZ)
find_program(DPKG_PROGRAM dpkg)
mark_as_advanced(DPKG_PROGRAM)
if(DPKG_PROGRAM)
    list(APPEND CPACK_GENERATOR DEB)
endif()

# TGZ: kodo-VERSION-SYSTEM.tar.gz and apart-VERSION-SYSTEM.tar.gz. With shared libraries there is
# one archive, since the game needs them.
set(system ${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_PACKAGE_FILE_NAME kodo-${system})
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_ENGINE_FILE_NAME kodo-${system})
set(CPACK_ARCHIVE_GAME_FILE_NAME apart-${system})
set(CPACK_KODO_TGZ_GROUPING ONE_PER_GROUP) # read by cpack_options.cmake
if(BUILD_SHARED_LIBS)
    set(CPACK_KODO_TGZ_GROUPING ALL_COMPONENTS_IN_ONE)
endif()

# DEB. dpkg-shlibdeps is in dpkg-dev; without it a package does not name the libraries it needs.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/deb_documents.cmake)
set(CPACK_KODO_SOURCE ${PROJECT_SOURCE_DIR})
find_program(SHLIBDEPS_PROGRAM dpkg-shlibdeps)
mark_as_advanced(SHLIBDEPS_PROGRAM)
if(SHLIBDEPS_PROGRAM)
    set(shlibdeps ON)
else()
    set(shlibdeps OFF)
endif()

# kodo_package(COMPONENT PACKAGE SECTION [DEPENDS list] [SHLIBDEPS])
function(kodo_package component package section)
    cmake_parse_arguments(arg "SHLIBDEPS" "DEPENDS" "" ${ARGN})
    string(TOUPPER CPACK_DEBIAN_${component} prefix)
    set(${prefix}_PACKAGE_NAME ${package} PARENT_SCOPE)
    set(${prefix}_PACKAGE_SECTION ${section} PARENT_SCOPE)
    set(${prefix}_PACKAGE_DEPENDS ${arg_DEPENDS} PARENT_SCOPE)
    if(arg_SHLIBDEPS)
        set(${prefix}_PACKAGE_SHLIBDEPS ${shlibdeps} PARENT_SCOPE)
    endif()
    set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
endfunction()

set(CPACK_COMPONENTS_ALL "")
set(runtime "")
if(BUILD_SHARED_LIBS)
    set(package libkodo${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    set(runtime "${package} (= ${PROJECT_VERSION})")
    kodo_package(kodo-runtime ${package} libs SHLIBDEPS)
    set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/engine) # for the game
endif()
kodo_package(kodo-dev libkodo-dev libdevel DEPENDS ${runtime})
if(TARGET kodo_c)
    set(package libkodo-c${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    kodo_package(kodo-c ${package} libs DEPENDS ${runtime} SHLIBDEPS)
    kodo_package(kodo-c-dev libkodo-c-dev libdevel
        DEPENDS "${package} (= ${PROJECT_VERSION}), libkodo-dev (= ${PROJECT_VERSION})")
    kodo_package(kodo-python python3-kodo python
        DEPENDS "${package} (= ${PROJECT_VERSION}), python3 (>= 3.9)")
endif()
if(TARGET kodo_sfml)
    kodo_package(kodo-sfml-dev libkodo-sfml-dev libdevel
        DEPENDS "libkodo-dev (= ${PROJECT_VERSION}), libsfml-dev (>= 2.5)")
endif()
if(TARGET apart-headless)
    kodo_package(apart apart games DEPENDS ${runtime} SHLIBDEPS)
endif()

set(libraries "the library in single precision")
if(KODO_DOUBLE)
    set(libraries "the libraries in single and in double precision")
endif()
include(CPack)
cpack_add_component_group(engine)
cpack_add_component_group(game)
cpack_add_component(kodo-runtime GROUP engine
    DISPLAY_NAME "Kodo, shared libraries"
    DESCRIPTION "2D rigid-body engine, shared libraries
Rigid bodies, joints, force fields and continuous collision for games. The
same input gives the same bits on every machine. This package holds
${libraries}.")
cpack_add_component(kodo-dev GROUP engine
    DISPLAY_NAME "Kodo, files for development"
    DESCRIPTION "2D rigid-body engine, files for development
Rigid bodies, joints, force fields and continuous collision for games. The
same input gives the same bits on every machine. This package holds the
headers, ${libraries},
and the files for CMake and pkg-config.")
cpack_add_component(kodo-c GROUP engine
    DISPLAY_NAME "Kodo, C interface"
    DESCRIPTION "2D rigid-body engine, libraries with a C interface
Rigid bodies, joints, force fields and continuous collision for games, for C
and for languages that call C. The same input gives the same bits on every
machine.")
cpack_add_component(kodo-c-dev GROUP engine DEPENDS kodo-c
    DISPLAY_NAME "Kodo, C interface, files for development"
    DESCRIPTION "2D rigid-body engine, files for development in C
The header kodo.h, and the files for CMake and pkg-config.")
cpack_add_component(kodo-python GROUP engine DEPENDS kodo-c
    DISPLAY_NAME "Kodo, Python module"
    DESCRIPTION "2D rigid-body engine, module for Python
Rigid bodies, joints, force fields and continuous collision for games and for
the training of agents, by ctypes on the C interface.")
cpack_add_component(kodo-sfml-dev GROUP engine DEPENDS kodo-dev
    DISPLAY_NAME "Kodo with SFML, files for development"
    DESCRIPTION "2D rigid-body engine, drawing with SFML, files for development
A window, text, textures and the drawing of a world of Kodo, on SFML 2.5.")
cpack_add_component(apart GROUP game
    DISPLAY_NAME "aPart"
    DESCRIPTION "Breakout game whose blocks come apart
Blocks break where they are struck, and every piece is a rigid body. What the
paddle catches is welded to it and changes its shape and weight. This package
also holds apart-headless, which replays and checks games in a terminal.")
