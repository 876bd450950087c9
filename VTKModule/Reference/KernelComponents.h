// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the march of several components reads, as members of a kernel; part of KernelBody.h.

const Components* Parts = nullptr;
std::vector<TablePlace> Places;
int componentCount = 0;
vec4 componentFactor{ 1, 1, 1, 1 };

/** Beside the scalars. */
void useComponentTables(const Components& components, const ScalarRange& range)
{
  Parts = &components;
  Places = components.places(*Table, range);
  componentCount = components.count();
  const auto& f = components.Factors;
  componentFactor = vec4(Real(f[0]), Real(f[1]), Real(f[2]), Real(f[3]));
}

int fetchTableFirst(int table) const { return Places[table].First; }
int fetchTableSize(int table) const { return Places[table].Size; }
vec4 fetchTableIntegralUnit(int table) const
{
  const auto& u = Places[table].IntegralUnit;
  return vec4(Real(u[0]), Real(u[1]), Real(u[2]), Real(u[3]));
}
vec2 fetchTablePlace(int table) const
{
  return vec2(Real(Places[table].Scale), Real(Places[table].Offset));
}
#if TETMARCH_STRUCTURED
vec3 fetchExtraValues(int i, int j, int k) const
{
  const auto value = [&](int component)
  { return component < componentCount ? fetchValueOf(component, i, j, k) : Real(0); };
  return vec3(value(1), value(2), value(3));
}
#else
const ExtraScalars* Extra = nullptr;

void useComponents(
  const Components& components, const ExtraScalars& extra, const ScalarRange& range)
{
  useComponentTables(components, range);
  Extra = &extra;
}
vec3 fetchExtraScalars(uint i) const
{
  const std::size_t count = Extra->count();
  const float* s = &Extra->Values[count * i];
  return vec3(Real(s[0]), count > 1 ? Real(s[1]) : Real(0), count > 2 ? Real(s[2]) : Real(0));
}
#endif
// The table to which an entry of all tables belongs; the entry becomes that of this table.
const IntegralTable& tableAt(int& entry) const
{
  std::size_t k = Places.size() - 1;
  while (Places[k].First > entry)
  {
    --k;
  }
  entry -= Places[k].First;
  return k > 0 ? Parts->Tables[k - 1] : *Table;
}
vec4 fetchTableValue(int i) const
{
  const auto& v = tableAt(i).Values[i];
  return vec4(Real(v[0]), Real(v[1]), Real(v[2]), Real(v[3]));
}
uvec4 fetchTableIntegral(int i) const
{
  const auto& v = tableAt(i).Integrals[i];
  return uvec4(v[0], v[1], v[2], v[3]);
}
vec2 fetchTableVariations(int i) const
{
  const IntegralTable& table = tableAt(i);
  return vec2(Real(table.Variations[i]), Real(table.ExtinctionVariations[i]));
}
