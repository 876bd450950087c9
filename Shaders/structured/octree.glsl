// The leaves of an octree (Structured/Octree.h): cubes of cells of a lattice, in which the scalar is constant. Each leaf
// on a ray is found anew, from the table (Foley and Sugerman, "KD-tree acceleration structures for a GPU raytracer",
// 2005, restart so).

struct Leaf
{
  ivec3 low;   // its first cell along each axis
  int width;   // in cells of the lattice
  uint number;
};

bool isLeaf(uint node) { return node >> 31u != 0u; }

// One level down, to the node around the cell.
void descendOnce(ivec3 cell, INOUT(uint) node, INOUT(int) shift)
{
  if (!isLeaf(node) && shift > 0)
  {
    shift = shift - 1;
    int child = (cell.x >> shift & 1) + 2 * (cell.y >> shift & 1) + 4 * (cell.z >> shift & 1);
    node = fetchOctreeNode(int(node) + child);
  }
}

// Several levels at once where turns of loops are limited, and a gradient reads seven leaves.
void descend(ivec3 cell, INOUT(uint) node, INOUT(int) shift)
{
  descendOnce(cell, node, shift);
#if TETMARCH_LIMITS_TURNS && TETMARCH_EFFECTS
  descendOnce(cell, node, shift);
  descendOnce(cell, node, shift);
  descendOnce(cell, node, shift);
#endif
}

Leaf leafAround(ivec3 cell)
{
  Leaf leaf;
  leaf.low = cell;
  leaf.width = 1;
  leaf.number = 0u;
  if (hasOctree())
  {
    int shift = octreeShift;
    ivec3 at = ivec3(cell.x >> shift, cell.y >> shift, cell.z >> shift);
    uint node = fetchOctreeNode(at.x + octreeSize.x * (at.y + octreeSize.y * at.z));
#if TETMARCH_LIMITS_TURNS && TETMARCH_EFFECTS
    descend(cell, node, shift);
#endif
#if TETMARCH_COUNTS_TURNS
    countTurns(1);
#endif
    while (!isLeaf(node) && shift > 0)
    {
      descend(cell, node, shift);
#if TETMARCH_COUNTS_TURNS
      countTurns(1);
#endif
    }
    shift = shift + int(node >> OCTREE_NUMBER_BITS & 15u);
    leaf.low = ivec3(cell.x >> shift << shift, cell.y >> shift << shift, cell.z >> shift << shift);
    leaf.width = 1 << shift;
    leaf.number = node & ((1u << OCTREE_NUMBER_BITS) - 1u);
  }
  else
  {
    leaf.number = numberOfLatticeCell(cell);
  }
  return leaf;
}

uint numberOfCell(ivec3 cell) { return leafAround(cell).number; }

// The indices of its value.
ivec3 valueOfLeaf(Leaf leaf)
{
  int number = int(leaf.number);
  int row = (1 << OCTREE_ROW_SHIFT) - 1;
  return hasOctree()
    ? ivec3(number & row, number >> OCTREE_ROW_SHIFT & row, number >> (2 * OCTREE_ROW_SHIFT))
    : leaf.low;
}

// The planes through which the ray may leave it, one for each axis.
ivec3 planesAheadOf(Ray ray, Leaf leaf)
{
  ivec3 low = leaf.low;
  int width = leaf.width;
  return ivec3(ray.steps.x > 0 ? min(low.x + width, latticeCells.x) : low.x,
    ray.steps.y > 0 ? min(low.y + width, latticeCells.y) : low.y,
    ray.steps.z > 0 ? min(low.z + width, latticeCells.z) : low.z);
}
