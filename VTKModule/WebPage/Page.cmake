# The page without a scene as a C string, `tetmarch_page` in TetMarchWebPage.h: made by Web/bundle.cmake.
function (tetmarch_embed_page out_sources)
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}/../Web" ABSOLUTE)
  file(GLOB files CONFIGURE_DEPENDS "${folder}/*.js" "${folder}/*.html" "${folder}/*.css" "${folder}/modules.txt")
  set(page "${CMAKE_CURRENT_BINARY_DIR}/tetmarch_page.html")
  add_custom_command(OUTPUT "${page}"
    COMMAND "${CMAKE_COMMAND}" "-DFOLDER=${folder}" "-DOUTPUT=${page}" -P "${folder}/bundle.cmake"
    DEPENDS ${files} "${folder}/bundle.cmake"
    COMMENT "Putting the web page together")
  vtk_encode_string(INPUT "${page}" NAME tetmarch_page HEADER_OUTPUT header SOURCE_OUTPUT source)
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/TetMarchWebPage.h" CONTENT "#include \"tetmarch_page.h\"\n")
  set("${out_sources}" "${source}" "${header}" PARENT_SCOPE)
endfunction ()
