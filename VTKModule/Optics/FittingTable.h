// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The integral table of a property, with the resolution that an accuracy level requires.
#ifndef TetMarchOpticsFittingTable_h
#define TetMarchOpticsFittingTable_h

#include "Optics/AccuracyLevel.h"
#include "Optics/IntegralTable.h"
#include "Optics/TransferFunctions.h"

class vtkVolumeProperty;

namespace tetmarch
{

/**
 * The table of the functions over the scalars low..high. It has the LeastTableEntries of the level,
 * or four times as many, and so on up to MostTableEntries, until its difference from the functions
 * between entries is at most half of the level's tolerance (SampledFunctions::Deviation). With
 * spikes, the error of pictures is about that of the table.
 */
IntegralTable fittingTable(
  vtkVolumeProperty* property, OpacityLaw law, double low, double high, const AccuracyLevel& level);

} // namespace tetmarch

#endif
