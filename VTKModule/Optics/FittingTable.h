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
 * The functions over the scalars low..high. The table has LeastTableEntries of the level, or four
 * times as many, and so on up to MostTableEntries: until between its entries it is off from the
 * functions by no more than half of the level's tolerance (SampledFunctions::Deviation). Where
 * there are spikes, pictures are off by about as much as the table.
 */
IntegralTable fittingTable(
  vtkVolumeProperty* property, OpacityLaw law, double low, double high, const AccuracyLevel& level);

} // namespace tetmarch

#endif
