// Gradients, and the gradient opacity; bound by GL/EffectTextures. Gradients of a lattice are differences of its
// values.
#if !TETMARCH_STRUCTURED
uniform samplerBuffer gradientBuffer; // of the scalar, at the vertices or in the tetrahedra
#if TETMARCH_CELL_GRADIENTS && TETMARCH_SPLIT_CELLS
uniform samplerBuffer secondGradientBuffer;
vec3 fetchCellGradient(uint tet) { return fetchOfCell(gradientBuffer, secondGradientBuffer, tet).xyz; }
#elif TETMARCH_CELL_GRADIENTS
vec3 fetchCellGradient(uint tet) { return BUFFER_TEXEL(gradientBuffer, int(tet)).xyz; }
#else
vec3 fetchGradient(uint vertex) { return BUFFER_TEXEL(gradientBuffer, int(vertex)).xyz; }
#endif
#endif

#if TETMARCH_GRADIENT_OPACITY
uniform samplerBuffer gradientOpacityBuffer;
uniform int gradientOpacitySize;
uniform float gradientOpacityScale; // factor from the length of a gradient to a position in the table
float fetchGradientOpacity(int i) { return BUFFER_TEXEL(gradientOpacityBuffer, i).x; }
#endif

#if TETMARCH_SCATTERING
uniform float gradientUnit; // of the stored gradients, in scalars 0..1 over the radius of the mesh
#endif
