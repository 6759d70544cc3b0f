# SPDX-License-Identifier: MIT
# Read by cpack once for each kind of package.
if(CPACK_GENERATOR STREQUAL "DEB")
    set(CPACK_COMPONENTS_GROUPING IGNORE)
    set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each component has its own
else()
    set(CPACK_COMPONENTS_GROUPING ${CPACK_KODO_TGZ_GROUPING})
    set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
    set(CPACK_PRE_BUILD_SCRIPTS "")
endif()
