// The opaque surfaces that cast shadows; bound by GL/EffectTextures, packed by Light/OpaqueShadows.
//
// First four texels for each surface: three rows of the matrix from the normalised frame to its coordinates; then the
// number of leaves, that of triangles of a leaf, and the first texel of its tree, divided by 4096 and the remainder. A
// tree has two texels a node: middle and half size of its box. The children of node n are 2 n and 2 n + 1, the root is
// 1, and the leaves are the nodes from that number on. The triangles of the leaves follow: three texels each.
uniform samplerBuffer opaqueSurfaceBuffer;
uniform int opaqueSurfaceCount;
uniform float opaqueReach; // maximum distance of a surface that casts a shadow

vec4 fetchOpaqueSurface(int texel) { return BUFFER_TEXEL(opaqueSurfaceBuffer, texel); }
