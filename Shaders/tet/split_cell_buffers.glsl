// Data with one texel per tetrahedron, if there are more tetrahedra than a texture buffer has texels: the second buffer
// contains those beyond the first one. Bound by GL/MeshTextures.
uniform usamplerBuffer secondCellBuffer;
uniform int cellsOfFirstBuffer;

uvec4 fetchCell(uint tet)
{
  int i = int(tet);
  if (i < cellsOfFirstBuffer)
  {
    return BUFFER_TEXEL(cellBuffer, i);
  }
  return BUFFER_TEXEL(secondCellBuffer, i - cellsOfFirstBuffer);
}

#if !TETMARCH_POINT_SCALARS || TETMARCH_CELL_GRADIENTS || TETMARCH_CORNER_SCALARS
vec4 fetchOfCell(samplerBuffer first, samplerBuffer second, uint tet)
{
  int i = int(tet);
  if (i < cellsOfFirstBuffer)
  {
    return BUFFER_TEXEL(first, i);
  }
  return BUFFER_TEXEL(second, i - cellsOfFirstBuffer);
}
#endif

#if !TETMARCH_POINT_SCALARS
uniform samplerBuffer secondCellScalarBuffer;
float fetchCellScalar(uint tet) { return fetchOfCell(cellScalarBuffer, secondCellScalarBuffer, tet).x; }
#endif

#if TETMARCH_CORNER_SCALARS
uniform samplerBuffer secondCornerScalarBuffer;
vec4 fetchCornerScalars(uint tet) { return fetchOfCell(cornerScalarBuffer, secondCornerScalarBuffer, tet); }
#endif

#if TETMARCH_COMPONENTS && !TETMARCH_POINT_SCALARS
uniform samplerBuffer secondExtraScalarBuffer;
vec3 fetchExtraScalars(uint tet) { return fetchOfCell(extraScalarBuffer, secondExtraScalarBuffer, tet).xyz; }
#endif
