// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchObjectFactory.h"

#include "vtkTetMarchProjectedTetrahedraMapper.h"
#include "vtkTetMarchSmartVolumeMapper.h"

#include "vtkCollection.h"
#include "vtkCollectionIterator.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <string>

namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkTetMarchProjectedTetrahedraMapper);
VTK_CREATE_CREATE_FUNCTION(vtkTetMarchSmartVolumeMapper);

// A class of VTK, our replacement, and the variable that enables it.
struct Replacement
{
  const char* Replaced;
  const char* Ours;
  const char* Variable; // of the environment
};
constexpr Replacement ProjectedTetrahedra{ "vtkProjectedTetrahedraMapper",
  "vtkTetMarchProjectedTetrahedraMapper", "TETMARCH_REPLACE_PROJECTED_TETRAHEDRA" };
constexpr Replacement SmartVolume{ "vtkSmartVolumeMapper", "vtkTetMarchSmartVolumeMapper",
  "TETMARCH_REPLACE_SMART_VOLUME" };

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

bool replaces(const Replacement& which)
{
  vtkTetMarchObjectFactory* factory = registeredFactory();
  return factory && factory->GetEnableFlag(which.Replaced, which.Ours);
}

// VTK uses the first factory that overrides the class, so the overrides of others are disabled.
void setReplaces(const Replacement& which, bool wanted)
{
  vtkTetMarchObjectFactory* factory = registeredFactory();
  if (wanted == replaces(which))
  {
    return;
  }
  if (!factory)
  {
    vtkNew<vtkTetMarchObjectFactory> made; // replaces nothing yet
    vtkObjectFactory::RegisterFactory(made);
    factory = made;
  }
  vtkObjectFactory::SetAllEnableFlags(wanted ? 0 : 1, which.Replaced);
  factory->SetEnableFlag(wanted ? 1 : 0, which.Replaced, which.Ours);
  if (!replaces(ProjectedTetrahedra) && !replaces(SmartVolume))
  {
    vtkObjectFactory::UnRegisterFactory(factory);
  }
}

bool isWanted(const Replacement& which)
{
  const char* value = std::getenv(which.Variable);
  return value && *value && std::string(value) != "0";
}

// Evaluated when the library is loaded.
const bool IsAskedFor = []
{
  bool any = false;
  for (const Replacement& which : { ProjectedTetrahedra, SmartVolume })
  {
    if (isWanted(which))
    {
      setReplaces(which, true);
      any = true;
    }
  }
  return any;
}();
} // namespace

vtkStandardNewMacro(vtkTetMarchObjectFactory);

//------------------------------------------------------------------------------
vtkTetMarchObjectFactory::vtkTetMarchObjectFactory()
{
  this->RegisterOverride(ProjectedTetrahedra.Replaced, ProjectedTetrahedra.Ours,
    "marches rays instead of projecting tetrahedra", 0,
    vtkObjectFactoryCreatevtkTetMarchProjectedTetrahedraMapper);
  this->RegisterOverride(SmartVolume.Replaced, SmartVolume.Ours,
    "integrates cells instead of sampling them", 0,
    vtkObjectFactoryCreatevtkTetMarchSmartVolumeMapper);
}

//------------------------------------------------------------------------------
vtkTetMarchObjectFactory::~vtkTetMarchObjectFactory() = default;

//------------------------------------------------------------------------------
void vtkTetMarchObjectFactory::SetReplacesProjectedTetrahedra(bool wanted)
{
  setReplaces(ProjectedTetrahedra, wanted);
}
bool vtkTetMarchObjectFactory::GetReplacesProjectedTetrahedra()
{
  return replaces(ProjectedTetrahedra);
}

//------------------------------------------------------------------------------
void vtkTetMarchObjectFactory::SetReplacesSmartVolume(bool wanted)
{
  setReplaces(SmartVolume, wanted);
}
bool vtkTetMarchObjectFactory::GetReplacesSmartVolume() { return replaces(SmartVolume); }

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
  os << indent << "ReplacesSmartVolume: " << (GetReplacesSmartVolume() ? "On" : "Off") << "\n";
}
