// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The methods of vtkTetMarchSettings for classes that have a GetSettings()
 *
 * A class has them by one line in its body, whichever class of VTK it derives from:
 *
 *     vtkTetMarchSettingsMethodsMacro();
 *
 * VTK's wrappers for Python and for ParaView expand such macros.
 */
#ifndef vtkTetMarchSettingsMacros_h
#define vtkTetMarchSettingsMacros_h

#include "vtkTetMarchSettings.h"

/** Getters of VTK may be const from 9.3 on, and so those that override them. */
#ifdef VTK_FUTURE_CONST
#define VTK_TETMARCH_FUTURE_CONST VTK_FUTURE_CONST
#else
#define VTK_TETMARCH_FUTURE_CONST
#endif

/** The settings' enumerators as those of this class. */
#define vtkTetMarchSettingsEnumsMacro()                                                            \
  enum OpacityLawType                                                                              \
  {                                                                                                \
    UNSTRUCTURED = vtkTetMarchSettings::UNSTRUCTURED,                                              \
    STRUCTURED = vtkTetMarchSettings::STRUCTURED                                                   \
  };                                                                                               \
  enum AccuracyLevelType                                                                           \
  {                                                                                                \
    FAST = vtkTetMarchSettings::FAST,                                                              \
    DEFAULT = vtkTetMarchSettings::DEFAULT,                                                        \
    ACCURATE = vtkTetMarchSettings::ACCURATE,                                                      \
    REFERENCE = vtkTetMarchSettings::REFERENCE,                                                    \
    SAMPLED = vtkTetMarchSettings::SAMPLED                                                         \
  };                                                                                               \
  enum ViewModeType                                                                                \
  {                                                                                                \
    VIEW_PICTURE = vtkTetMarchSettings::VIEW_PICTURE,                                              \
    VIEW_ERROR_BOUND = vtkTetMarchSettings::VIEW_ERROR_BOUND,                                      \
    VIEW_CELLS = vtkTetMarchSettings::VIEW_CELLS,                                                  \
    VIEW_LOOKUPS = vtkTetMarchSettings::VIEW_LOOKUPS,                                              \
    VIEW_ILLUMINATION = vtkTetMarchSettings::VIEW_ILLUMINATION,                                    \
    VIEW_GRADIENTS = vtkTetMarchSettings::VIEW_GRADIENTS,                                          \
    VIEW_BOUNDARY_FACES = vtkTetMarchSettings::VIEW_BOUNDARY_FACES,                                \
    VIEW_BOUNDARY_COORDINATES = vtkTetMarchSettings::VIEW_BOUNDARY_COORDINATES                     \
  };                                                                                               \
  enum ShaderStageType                                                                             \
  {                                                                                                \
    AUTOMATIC_STAGE = vtkTetMarchSettings::AUTOMATIC_STAGE,                                        \
    FRAGMENT_STAGE = vtkTetMarchSettings::FRAGMENT_STAGE,                                          \
    COMPUTE_STAGE = vtkTetMarchSettings::COMPUTE_STAGE                                             \
  };                                                                                               \
  enum GradientTypes                                                                               \
  {                                                                                                \
    VERTEX_GRADIENTS = vtkTetMarchSettings::VERTEX_GRADIENTS,                                      \
    CELL_GRADIENTS = vtkTetMarchSettings::CELL_GRADIENTS                                           \
  };                                                                                               \
  enum ShadowMethods                                                                               \
  {                                                                                                \
    SHADOWS_OFF = vtkTetMarchSettings::SHADOWS_OFF,                                                \
    SHADOWS_AUTOMATIC = vtkTetMarchSettings::SHADOWS_AUTOMATIC,                                    \
    SHADOWS_AT_VERTICES = vtkTetMarchSettings::SHADOWS_AT_VERTICES,                                \
    SHADOWS_ALONG_RAYS = vtkTetMarchSettings::SHADOWS_ALONG_RAYS                                   \
  }

/** A property of any type. */
#define vtkTetMarchForwardMacro(name, type)                                                        \
  virtual void Set##name(type value) { this->GetSettings()->Set##name(value); }                    \
  virtual type Get##name() { return this->GetSettings()->Get##name(); }

/** A property with a least and a greatest value. */
#define vtkTetMarchForwardClampedMacro(name, type)                                                 \
  vtkTetMarchForwardMacro(name, type);                                                             \
  virtual type Get##name##MinValue() { return this->GetSettings()->Get##name##MinValue(); }        \
  virtual type Get##name##MaxValue() { return this->GetSettings()->Get##name##MaxValue(); }

/** A property that is on or off. */
#define vtkTetMarchForwardSwitchMacro(name)                                                        \
  vtkTetMarchForwardMacro(name, bool);                                                             \
  virtual void name##On() { this->Set##name(true); }                                               \
  virtual void name##Off() { this->Set##name(false); }

/** A property that is two numbers. */
#define vtkTetMarchForwardVector2Macro(name, type)                                                 \
  virtual void Set##name(type first, type second)                                                  \
  {                                                                                                \
    this->GetSettings()->Set##name(first, second);                                                 \
  }                                                                                                \
  void Set##name(const type values[2]) { this->Set##name(values[0], values[1]); }                  \
  virtual type* Get##name() VTK_SIZEHINT(2) { return this->GetSettings()->Get##name(); }           \
  VTK_WRAPEXCLUDE                                                                                  \
  virtual void Get##name(type& first, type& second)                                                \
  {                                                                                                \
    this->GetSettings()->Get##name(first, second);                                                 \
  }                                                                                                \
  VTK_WRAPEXCLUDE                                                                                  \
  virtual void Get##name(type values[2]) { this->Get##name(values[0], values[1]); }

/** A property that is one of an enumeration. */
#define vtkTetMarchForwardChoiceMacro(name)                                                        \
  vtkTetMarchForwardClampedMacro(name, int);                                                       \
  const char* Get##name##AsString() const { return this->GetSettings()->Get##name##AsString(); }

/** One of its choices. */
#define vtkTetMarchForwardChoiceToMacro(name, choice)                                              \
  void Set##name##To##choice() { this->GetSettings()->Set##name##To##choice(); }

/** The settings' enumerators and methods, but for those of which a vtkSmartVolumeMapper has some of
 * that name. */
#define vtkTetMarchOwnSettingsMethodsMacro()                                                       \
  vtkTetMarchSettingsEnumsMacro();                                                                 \
  vtkTetMarchForwardChoiceMacro(OpacityLaw);                                                       \
  vtkTetMarchForwardChoiceToMacro(OpacityLaw, Unstructured);                                       \
  vtkTetMarchForwardChoiceToMacro(OpacityLaw, Structured);                                         \
  vtkTetMarchForwardSwitchMacro(DrawNanCells);                                                     \
  vtkTetMarchForwardChoiceMacro(AccuracyLevel);                                                    \
  vtkTetMarchForwardChoiceToMacro(AccuracyLevel, Fast);                                            \
  vtkTetMarchForwardChoiceToMacro(AccuracyLevel, Default);                                         \
  vtkTetMarchForwardChoiceToMacro(AccuracyLevel, Accurate);                                        \
  vtkTetMarchForwardChoiceToMacro(AccuracyLevel, Reference);                                       \
  vtkTetMarchForwardChoiceToMacro(AccuracyLevel, Sampled);                                         \
  vtkTetMarchForwardClampedMacro(ErrorTolerance, double);                                          \
  vtkTetMarchForwardClampedMacro(FrameTimeBudget, double);                                         \
  vtkTetMarchForwardClampedMacro(ErrorBudget, double);                                             \
  vtkTetMarchForwardClampedMacro(ImageSampleDistance, double);                                     \
  vtkTetMarchForwardClampedMacro(MinimumImageSampleDistance, double);                              \
  vtkTetMarchForwardClampedMacro(MaximumImageSampleDistance, double);                              \
  vtkTetMarchForwardClampedMacro(MaxDrawTimeInSeconds, double);                                    \
  vtkTetMarchForwardChoiceMacro(ShaderStage);                                                      \
  vtkTetMarchForwardChoiceToMacro(ShaderStage, Automatic);                                         \
  vtkTetMarchForwardChoiceToMacro(ShaderStage, Fragment);                                          \
  vtkTetMarchForwardChoiceToMacro(ShaderStage, Compute);                                           \
  vtkTetMarchForwardChoiceMacro(ViewMode);                                                         \
  vtkTetMarchForwardChoiceToMacro(ViewMode, Picture);                                              \
  vtkTetMarchForwardChoiceToMacro(ViewMode, ErrorBound);                                           \
  vtkTetMarchForwardChoiceToMacro(ViewMode, Cells);                                                \
  vtkTetMarchForwardChoiceToMacro(ViewMode, Lookups);                                              \
  vtkTetMarchForwardChoiceToMacro(ViewMode, Illumination);                                         \
  vtkTetMarchForwardChoiceToMacro(ViewMode, Gradients);                                            \
  vtkTetMarchForwardChoiceToMacro(ViewMode, BoundaryFaces);                                        \
  vtkTetMarchForwardChoiceToMacro(ViewMode, BoundaryCoordinates);                                  \
  vtkTetMarchForwardSwitchMacro(AutomaticViewRange);                                               \
  vtkTetMarchForwardVector2Macro(ViewRange, double);                                               \
  vtkTetMarchForwardChoiceMacro(GradientType);                                                     \
  vtkTetMarchForwardChoiceToMacro(GradientType, Vertex);                                           \
  vtkTetMarchForwardChoiceToMacro(GradientType, Cell);                                             \
  vtkTetMarchForwardChoiceMacro(ShadowMethod);                                                     \
  vtkTetMarchForwardChoiceToMacro(ShadowMethod, Off);                                              \
  vtkTetMarchForwardChoiceToMacro(ShadowMethod, Automatic);                                        \
  vtkTetMarchForwardChoiceToMacro(ShadowMethod, AtVertices);                                       \
  vtkTetMarchForwardChoiceToMacro(ShadowMethod, AlongRays);                                        \
  vtkTetMarchForwardSwitchMacro(OpaqueShadows);                                                    \
  vtkTetMarchForwardSwitchMacro(AmbientOcclusion);                                                 \
  vtkTetMarchForwardClampedMacro(AmbientOcclusionRadius, double);                                  \
  vtkTetMarchForwardClampedMacro(AmbientOcclusionDirections, int);                                 \
  vtkTetMarchForwardClampedMacro(LightTimeBudget, double);                                         \
  vtkTetMarchForwardClampedMacro(PickOpacityThreshold, double);                                    \
  vtkTetMarchForwardSwitchMacro(CollectDiagnostics)

/** All of the settings' enumerators and methods. */
#define vtkTetMarchSettingsMethodsMacro()                                                          \
  vtkTetMarchOwnSettingsMethodsMacro();                                                            \
  vtkTetMarchForwardSwitchMacro(AutoAdjustSampleDistances);                                        \
  vtkTetMarchForwardClampedMacro(MaxMemoryInBytes, vtkIdType);                                     \
  vtkTetMarchForwardClampedMacro(VolumetricScatteringBlending, float);                             \
  vtkTetMarchForwardClampedMacro(GlobalIlluminationReach, float)

#endif
