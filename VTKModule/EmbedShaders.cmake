# Every file of Shaders/ becomes a C string; TetMarchShaderFiles.h lists them by their paths in `folder`.
function (tetmarch_embed_shaders out_sources folder)
  set(sources)
  set(includes "")
  set(rows "")
  foreach (file IN LISTS ARGN)
    file(RELATIVE_PATH name "${folder}" "${file}")
    string(MAKE_C_IDENTIFIER "tetmarch_${name}" identifier)
    vtk_encode_string(INPUT "${file}" NAME "${identifier}" HEADER_OUTPUT header SOURCE_OUTPUT source)
    list(APPEND sources "${source}" "${header}")
    string(APPEND includes "#include \"${identifier}.h\"\n")
    string(APPEND rows "  { \"${name}\", ${identifier} },\n")
  endforeach ()
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/TetMarchShaderFiles.h" @ONLY CONTENT
"// Made by EmbedShaders.cmake.
@includes@
struct ShaderFile
{
  const char* Name;
  const char* Text;
};

static const ShaderFile ShaderFiles[] = {
@rows@};
")
  list(APPEND sources "${CMAKE_CURRENT_BINARY_DIR}/TetMarchShaderFiles.h")
  set("${out_sources}" "${sources}" PARENT_SCOPE)
endfunction ()
