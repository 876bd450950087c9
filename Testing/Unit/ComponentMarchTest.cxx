// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march of several components through tetrahedra, against closed forms and a quadrature by
// VTK's own functions.
#include "Reference/ColorAndOpacityCellKernel.h"
#include "Reference/ColorAndOpacityPointKernel.h"
#include "Reference/DirectColorCellKernel.h"
#include "Reference/DirectColorPointKernel.h"
#include "Reference/FastColorAndOpacityPointKernel.h"
#include "Reference/FastDirectColorPointKernel.h"
#include "Reference/FastIndependentPointKernel.h"
#include "Reference/IndependentCellKernel.h"
#include "Reference/IndependentPointKernel.h"

#include "TetKinds.h"

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Unlit = Tetrahedra<ComponentRays>;
template <int Components>
using IndependentKind = MarchKind<Unlit, Components, true, IndependentPointKernel,
  FastIndependentPointKernel, IndependentCellKernel>;

using Kinds = ::testing::Types<IndependentKind<2>, IndependentKind<3>, IndependentKind<4>,
  MarchKind<Unlit, 2, false, ColorAndOpacityPointKernel, FastColorAndOpacityPointKernel,
    ColorAndOpacityCellKernel>,
  MarchKind<Unlit, 4, false, DirectColorPointKernel, FastDirectColorPointKernel,
    DirectColorCellKernel>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Tetrahedra, MarchOf, Kinds, KindNames);
INSTANTIATE_TYPED_TEST_SUITE_P(Tetrahedra, CellsOf, Kinds, KindNames);

TEST(ComponentMarch, ColorsThatAreLinearInAnEvenFog)
{
  ComponentRays rays(jitteredLattice(3, 0.15), 4, false);
  expectLinearColors<DirectColorPointKernel<double>>(rays);
}
} // namespace
