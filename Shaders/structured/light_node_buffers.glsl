// The nodes at which the light of a structured volume is kept; Structured/LightNodes.h. Bound by GL/LatticeTextures.
uniform ivec3 lightNodes; // along i, j, k
#if TETMARCH_VERTEX_LIGHT
// Where light is read.
uniform vec3 lightLow;     // of the first node, in lattice coordinates
uniform vec3 perLightStep; // nodes a unit of lattice coordinates
#else
// Where it is made.
uniform mat4 lightNodeMatrix; // from the numbers of a node to the normalised frame
vec3 pointOfNode(uvec3 node) { return (lightNodeMatrix * vec4(vec3(node), 1.0)).xyz; }
#endif
