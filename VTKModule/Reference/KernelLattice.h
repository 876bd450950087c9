// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The lattice that a kernel marches through, as its members; part of KernelBody.h.

const Lattice* Cells = nullptr;
const StoredValues* Values = nullptr; // of the first scalar, then of those drawn with it

const Octree* Tree = nullptr; // of constant cells, whose leaves are the cells

const BlockDistances* Empty = nullptr;

ivec3 latticeCells{ 0, 0, 0 };
ivec3 firstValue{ 0, 0, 0 };
ivec3 lastValue{ 0, 0, 0 };
ivec3 firstPlane{ 0, 0, 0 };
vec3 latticeShift{ 0, 0, 0 };
vec3 latticeHalfLength{ 0, 0, 0 };
std::array<Real, 12> latticeMatrix{};
Real sampleStep = 1;
Real samplesPerDepth = 1;
ivec3 blockCount{ 0, 0, 0 };
int octreeShift = 0;
ivec3 octreeSize{ 0, 0, 0 };
ivec3 lightNodes{ 0, 0, 0 };
vec3 lightLow{ 0, 0, 0 };
vec3 perLightStep{ 0, 0, 0 };
std::array<Real, 12> lightNodeMatrix{};

static vec3 rowsTimes(const std::array<Real, 12>& m, vec3 v, Real w)
{
  const auto row = [&](int r)
  { return m[4 * r] * v.x + m[4 * r + 1] * v.y + m[4 * r + 2] * v.z + m[4 * r + 3] * w; };
  return vec3(row(0), row(1), row(2));
}
vec3 toLattice(vec3 point) const { return rowsTimes(latticeMatrix, point, Real(1)); }
vec3 directionToLattice(vec3 direction) const
{
  return rowsTimes(latticeMatrix, direction, Real(0));
}
vec3 gradientFromLattice(vec3 g) const
{
  const auto& m = latticeMatrix;
  return vec3(m[0] * g.x + m[4] * g.y + m[8] * g.z, m[1] * g.x + m[5] * g.y + m[9] * g.z,
    m[2] * g.x + m[6] * g.y + m[10] * g.z);
}
vec3 pointOfNode(uvec3 node) const
{
  return rowsTimes(lightNodeMatrix, vec3(Real(node.x), Real(node.y), Real(node.z)), Real(1));
}
/** Those of i, of j, of k, one behind the other. */
Real fetchPlane(int i) const
{
  const int axis = i < firstPlane.y ? 0 : (i < firstPlane.z ? 1 : 2);
  const int first = axis == 0 ? firstPlane.x : (axis == 1 ? firstPlane.y : firstPlane.z);
  return Real(Cells->Axes[axis].plane(i - first));
}

bool hasOctree() const { return Tree != nullptr; }
uint fetchOctreeNode(int i) const { return Tree->Nodes[i]; }

int fetchBlockDistance(int i) const { return Empty->Distances[i]; }

/** For kernels that leap. */
void useEmptySpace(const BlockDistances& empty)
{
  Empty = &empty;
  blockCount = ivec3(empty.Blocks[0], empty.Blocks[1], empty.Blocks[2]);
}

/** The leaves of the tree, which may be nullptr, are the cells. */
void useOctree(const Octree* tree)
{
  Tree = tree;
  octreeShift = tree ? tree->Shift : 0;
  octreeSize = tree ? ivec3(tree->Size[0], tree->Size[1], tree->Size[2]) : ivec3(0, 0, 0);
}

/** For kernels that take samples. */
void useSamples(const RaySamples& samples, const VolumeFrame& frame)
{
  sampleStep = Real(samples.step(frame));
  samplesPerDepth = Real(1 / samples.step(frame));
}

Real fetchValueOf(int component, int i, int j, int k) const
{
  const StoredValues& values = Values[component];
  const std::size_t row = static_cast<std::size_t>(lastValue.x) + 1;
  const std::size_t layer = row * (static_cast<std::size_t>(lastValue.y) + 1);
  const Real read =
    values.read<Real>(std::clamp(i, 0, lastValue.x) + row * std::clamp(j, 0, lastValue.y) +
                      layer * std::clamp(k, 0, lastValue.z));
  return read * Real(values.Scale) + Real(values.Offset);
}
Real fetchValue(int i, int j, int k) const { return fetchValueOf(0, i, j, k); }

/** Four values of a layer, in the order of GLSL's textureGather(). */
vec4 fetchValuesOf(int component, int i, int j, int k) const
{
  return vec4(fetchValueOf(component, i, j + 1, k), fetchValueOf(component, i + 1, j + 1, k),
    fetchValueOf(component, i + 1, j, k), fetchValueOf(component, i, j, k));
}
vec4 fetchValues(int i, int j, int k) const { return fetchValuesOf(0, i, j, k); }

/** Of several components the values are the first of an array. */
void useLattice(const Lattice& lattice, const StoredValues& values)
{
  Cells = &lattice;
  Values = &values;
  const auto& axes = lattice.Axes;
  const auto toInts = [&](const auto& of) { return ivec3(of(axes[0]), of(axes[1]), of(axes[2])); };
  const auto toReals = [&](const auto& of)
  { return vec3(Real(of(axes[0])), Real(of(axes[1])), Real(of(axes[2]))); };
  latticeCells = toInts([](const LatticeAxis& axis) { return axis.Cells; });
  firstValue = toInts([](const LatticeAxis& axis) { return axis.FirstValue; });
  lastValue = toInts([](const LatticeAxis& axis) { return axis.Values - 1; });
  latticeShift = toReals([](const LatticeAxis& axis) { return axis.Shift; });
  latticeHalfLength = toReals([](const LatticeAxis& axis) { return axis.HalfLength; });
  const auto toReal = [](double value) { return Real(value); };
  std::transform(
    lattice.FromNormalized.begin(), lattice.FromNormalized.end(), latticeMatrix.begin(), toReal);
  const LightNodes nodes = lightNodesOf(lattice);
  lightNodes = ivec3(nodes.Along[0], nodes.Along[1], nodes.Along[2]);
  lightLow = vec3(Real(nodes.Low[0]), Real(nodes.Low[1]), Real(nodes.Low[2]));
  perLightStep = vec3(Real(1 / nodes.Step[0]), Real(1 / nodes.Step[1]), Real(1 / nodes.Step[2]));
  std::transform(
    nodes.ToNormalized.begin(), nodes.ToNormalized.end(), lightNodeMatrix.begin(), toReal);
  firstPlane = ivec3(0, latticeCells.x + 1, latticeCells.x + latticeCells.y + 2);
  mostSteps = mostStepsOf(lattice);
}
