// The nodes of an octree; Structured/Octree.h. Bound by GL/LatticeTextures.
uniform usamplerBuffer octreeBuffer;
uniform int octreeShift;  // a node of the table has 1 << octreeShift cells along each axis
uniform ivec3 octreeSize; // nodes of the table, along i, j, k
uint fetchOctreeNode(int i) { return BUFFER_TEXEL(octreeBuffer, i).x; }

// Kernels of the CPU reference march through lattices without one, too.
bool hasOctree() { return true; }
