# A Debian package of the plugin, for the ParaView that it was built with: cpack -G DEB in a build folder that was configured
# for the prefix /usr. "Utilities/plugin --package" does it.

math(EXPR next "${ParaView_VERSION_MINOR} + 1")
set(CPACK_PACKAGE_NAME paraview-exabricks)
set(CPACK_PACKAGE_VENDOR "ExaBricks for VTK")
set(CPACK_PACKAGE_CONTACT "The ExaBricks for VTK developers <exabricks@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Libraries of ParaView are its own, of which Debian's tools know no package.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS OFF)
string(CONCAT CPACK_DEBIAN_PACKAGE_DEPENDS
  "paraview (>= ${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}), paraview (<< ${ParaView_VERSION_MAJOR}.${next}~), "
  "libc6, libgomp1, libstdc++6, libvulkan1")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "mesa-vulkan-drivers (>= 24.1)")
include(CPack)
