// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Failure.h"

namespace tetmarch::bench
{
Scene makeScene(const Subject& subject, const DataFolders& folders)
{
  const Dataset dataset = makeDataset(subject.Dataset, folders);
  const bool own = subject.Functions == OwnFunctions;
  if (own && !dataset.Own)
  {
    throw Failure("dataset " + subject.Dataset + " has no functions of its own");
  }
  return { dataset.Grid, dataset.Array,
    own ? dataset.Own : makeFunctions(subject.Functions, dataset.Range), dataset.Range,
    dataset.Exact, subject.Dataset, {} };
}
} // namespace tetmarch::bench
