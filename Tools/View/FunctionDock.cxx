// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FunctionDock.h"

#include "Model.h"
#include "TransferFunctionEditor.h"

#include "vtkVolumeMapper.h"

namespace tetmarch
{

namespace
{
void ShowData(Model& model, TransferFunctionEditor* editor)
{
  Scene& scene = model.GetScene();
  editor->SetFunctions(scene.GetColor(), scene.GetOpacity());
  const Histogram& values = scene.GetData().Values;
  editor->SetHistogram(values.Counts, values.Low, values.High);
}

void ShowIsoValues(Model& model, TransferFunctionEditor* editor)
{
  const ViewState& state = model.GetState();
  const bool shown = state.BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND;
  const std::vector<double> values = shown ? state.IsoValues : std::vector<double>();
  if (editor->GetIsoValues() != values)
  {
    editor->SetIsoValues(values);
  }
}
} // namespace

TransferFunctionEditor* MakeFunctionEditor(Model& model)
{
  auto* editor = new TransferFunctionEditor;
  editor->setEnabled(model.HasData());
  QObject::connect(&model, &Model::DataChanged, editor,
    [&model, editor]
    {
      editor->setEnabled(model.HasData());
      if (model.HasData())
      {
        ShowData(model, editor);
      }
    });
  QObject::connect(
    &model, &Model::StateChanged, editor, [&model, editor] { ShowIsoValues(model, editor); });
  // Later, for the editor also tells of changes that are not its own: of a scene that is just about
  // to take other functions, point by point.
  QObject::connect(
    editor, &TransferFunctionEditor::Changed, &model, [&model] { model.TakeFunctions(); },
    Qt::QueuedConnection);
  QObject::connect(
    editor, &TransferFunctionEditor::DragBegan, &model, [&model] { model.BeginDrag(); });
  QObject::connect(
    editor, &TransferFunctionEditor::DragEnded, &model, [&model] { model.EndDrag(); });
  QObject::connect(editor, &TransferFunctionEditor::IsoValuesChanged, &model,
    [&model, editor]
    { model.Edit([editor](ViewState& state) { state.IsoValues = editor->GetIsoValues(); }); });
  return editor;
}

} // namespace tetmarch
