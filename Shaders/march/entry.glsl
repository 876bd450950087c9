// The entry of a ray into the volume.
struct Entry
{
  real depth;
  int face; // of the boundary of a mesh; -1: none
};
