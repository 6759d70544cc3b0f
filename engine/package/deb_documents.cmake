# SPDX-License-Identifier: MIT
# Run by cpack before it packs a DEB. Debian expects the documents of each package in
# share/doc/PACKAGE/copyright and share/doc/PACKAGE/changelog.gz.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # or SOURCE_DATE_EPOCH
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER CPACK_DEBIAN_${component}_PACKAGE_NAME package)
    set(package ${${package}})
    set(prefix ${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX})
    set(documents ${prefix}/share/doc)
    file(GLOB licence ${documents}/*/LICENSE)
    get_filename_component(folder ${licence} DIRECTORY)
    if(NOT folder STREQUAL ${documents}/${package})
        file(RENAME ${folder} ${documents}/${package})
    endif()
    file(RENAME ${documents}/${package}/LICENSE ${documents}/${package}/copyright)
    set(changelog ${CPACK_TEMPORARY_DIRECTORY}/changelog)
    file(WRITE ${changelog} "kodo (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * See CHANGELOG.md in the sources.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
    execute_process(COMMAND gzip -9nc ${changelog} COMMAND_ERROR_IS_FATAL ANY
        OUTPUT_FILE ${documents}/${package}/changelog.gz)
endforeach()
