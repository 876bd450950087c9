// Gradients, and the gradient opacity; bound by GL/EffectTextures.
#if TETMARCH_VERTEX_GRADIENTS && !TETMARCH_STRUCTURED
uniform samplerBuffer gradientBuffer; // of the scalar, at the vertices
vec3 fetchGradient(uint vertex) { return texelFetch(gradientBuffer, int(vertex)).xyz; }
#endif
#if TETMARCH_CELL_GRADIENTS && !TETMARCH_STRUCTURED
uniform samplerBuffer gradientBuffer; // of the scalar, in the tetrahedra
vec3 fetchCellGradient(uint tet) { return texelFetch(gradientBuffer, int(tet)).xyz; }
#endif

#if TETMARCH_GRADIENT_OPACITY
uniform samplerBuffer gradientOpacityBuffer;
uniform int gradientOpacitySize;
uniform float gradientOpacityScale; // from the length of a gradient to a position in the table
float fetchGradientOpacity(int i) { return texelFetch(gradientOpacityBuffer, i).x; }
#endif

#if TETMARCH_SCATTERING
uniform float gradientUnit; // of the stored gradients, in scalars 0..1 over the radius of the mesh
#endif
