// The nodes at which the light of a structured volume is stored; Structured/LightNodes.h. Bound by GL/LatticeTextures.
uniform ivec3 lightNodes; // along i, j, k
#if TETMARCH_VERTEX_LIGHT
// For reading light.
uniform vec3 lightLow;     // of the first node, in lattice coordinates
uniform vec3 perLightStep; // nodes per unit of lattice coordinates
#else
// For computing light.
uniform mat4 lightNodeMatrix; // from the indices of a node to the normalised frame
vec3 pointOfNode(uvec3 node) { return (lightNodeMatrix * vec4(vec3(node), 1.0)).xyz; }
#endif
