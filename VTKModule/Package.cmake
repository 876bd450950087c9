# What find_package(TetMarch) reads: VTK first, then the exported targets of the module.
include(CMakePackageConfigHelpers)
set(tetmarch_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/TetMarch")
configure_package_config_file(VTKModule/TetMarchConfig.cmake.in
  "${CMAKE_BINARY_DIR}/${tetmarch_cmake_dir}/TetMarchConfig.cmake"
  INSTALL_DESTINATION "${tetmarch_cmake_dir}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${tetmarch_cmake_dir}/TetMarchConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/${tetmarch_cmake_dir}/TetMarchConfig.cmake"
  "${CMAKE_BINARY_DIR}/${tetmarch_cmake_dir}/TetMarchConfigVersion.cmake"
  DESTINATION "${tetmarch_cmake_dir}"
  COMPONENT development)
