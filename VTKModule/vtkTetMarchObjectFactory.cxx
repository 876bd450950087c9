// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchObjectFactory.h"

#include "vtkTetMarchProjectedTetrahedraMapper.h"

#include "vtkCollection.h"
#include "vtkCollectionIterator.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <string>

namespace
{
const char* const Replaced = "vtkProjectedTetrahedraMapper";

VTK_CREATE_CREATE_FUNCTION(vtkTetMarchProjectedTetrahedraMapper);

vtkTetMarchObjectFactory* registeredFactory()
{
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  vtkCollectionSimpleIterator it;
  factories->InitTraversal(it);
  while (vtkObject* factory = factories->GetNextItemAsObject(it))
  {
    if (auto* ours = vtkTetMarchObjectFactory::SafeDownCast(factory))
    {
      return ours;
    }
  }
  return nullptr;
}

bool isWanted(const char* value) { return value && *value && std::string(value) != "0"; }

// Evaluated when the library is loaded.
const bool IsAskedFor = []
{
  const bool wanted = isWanted(std::getenv("TETMARCH_REPLACE_PROJECTED_TETRAHEDRA"));
  if (wanted)
  {
    vtkTetMarchObjectFactory::SetReplacesProjectedTetrahedra(true);
  }
  return wanted;
}();
} // namespace

vtkStandardNewMacro(vtkTetMarchObjectFactory);

//------------------------------------------------------------------------------
vtkTetMarchObjectFactory::vtkTetMarchObjectFactory()
{
  this->RegisterOverride(Replaced, "vtkTetMarchProjectedTetrahedraMapper",
    "marches rays instead of projecting tetrahedra", 1,
    vtkObjectFactoryCreatevtkTetMarchProjectedTetrahedraMapper);
}

//------------------------------------------------------------------------------
vtkTetMarchObjectFactory::~vtkTetMarchObjectFactory() = default;

//------------------------------------------------------------------------------
// VTK uses the first factory that overrides the class, so the overrides of others are disabled.
void vtkTetMarchObjectFactory::SetReplacesProjectedTetrahedra(bool replaces)
{
  vtkTetMarchObjectFactory* present = registeredFactory();
  if (replaces && !present)
  {
    vtkObjectFactory::SetAllEnableFlags(0, Replaced);
    vtkNew<vtkTetMarchObjectFactory> factory;
    vtkObjectFactory::RegisterFactory(factory);
  }
  else if (!replaces && present)
  {
    vtkObjectFactory::UnRegisterFactory(present);
    vtkObjectFactory::SetAllEnableFlags(1, Replaced);
  }
}

//------------------------------------------------------------------------------
bool vtkTetMarchObjectFactory::GetReplacesProjectedTetrahedra()
{
  return registeredFactory() != nullptr;
}

//------------------------------------------------------------------------------
const char* vtkTetMarchObjectFactory::GetVTKSourceVersion() { return VTK_SOURCE_VERSION; }

//------------------------------------------------------------------------------
const char* vtkTetMarchObjectFactory::GetDescription() { return "TetMarch"; }

//------------------------------------------------------------------------------
void vtkTetMarchObjectFactory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "ReplacesProjectedTetrahedra: " << (GetReplacesProjectedTetrahedra() ? "On" : "Off")
     << "\n";
}
