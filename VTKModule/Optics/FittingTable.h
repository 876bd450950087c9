// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The integral table of a property, as fine as an accuracy level asks for.
#ifndef TetMarchOpticsFittingTable_h
#define TetMarchOpticsFittingTable_h

#include "Optics/AccuracyLevel.h"
#include "Optics/IntegralTable.h"
#include "Optics/TransferFunctions.h"

class vtkVolumeProperty;

namespace tetmarch
{

/**
 * The table of the functions over the scalars low..high. It has the LeastTableEntries of the
 * level, or four times as many, and so on up to MostTableEntries, until it differs from the
 * functions by at most half of the level's tolerance between its entries
 * (SampledFunctions::Deviation). Where there are spikes, the error of pictures is about that of the
 * table.
 */
IntegralTable fittingTable(
  vtkVolumeProperty* property, OpacityLaw law, double low, double high, const AccuracyLevel& level);

} // namespace tetmarch

#endif
