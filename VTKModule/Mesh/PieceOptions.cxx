// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PieceOptions.h"

namespace tetmarch
{

double roundedToFloat(double x) { return double(static_cast<float>(x)); }

} // namespace tetmarch
