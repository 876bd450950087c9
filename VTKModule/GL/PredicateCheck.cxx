// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/PredicateCheck.h"

#include "GL/Driver.h"
#include "GL/FloatTarget.h"
#include "GL/ShaderDraw.h"
#include "GL/StateScope.h"
#include "GL/UploadedImage.h"
#include "Variants/PredicateCases.h"
#include "Variants/VariantKey.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkShaderProgram.h"

namespace tetmarch
{
namespace
{

class Check
{
public:
  explicit Check(vtkOpenGLRenderWindow* window)
    : Window(window)
  {
  }
  ~Check()
  {
    this->Draw.release();
    this->Answers.release(this->Window);
    this->Uploaded.release(this->Window);
  }
  Check(const Check&) = delete;
  Check& operator=(const Check&) = delete;

  /** How many answers are wrong. Returns an empty string, or why there are none. */
  std::string run(bool fused, int& wrong)
  {
    if (!this->Uploaded.texture() && !this->Uploaded.upload(this->Window, PredicateCases::Width,
                                       PredicateCases::Side, 4, this->Cases.texels()))
    {
      return "The GPU has no room for " + std::to_string(this->Cases.texels().size() * 4) +
             " bytes. Close what else uses it.";
    }
    const TargetScope state(this->Window, PredicateCases::Side, PredicateCases::Side);
    std::string error = this->draw(fused);
    if (error.empty())
    {
      wrong = this->Cases.countWrong(
        this->Answers.read(this->Window, 0), this->Answers.read(this->Window, 1), fused);
    }
    return error;
  }

private:
  std::string draw(bool fused)
  {
    VariantKey key;
    key.EntryLists = false;
    key.HasFma = fused;
    std::string error =
      this->Answers.bind(this->Window, PredicateCases::Side, PredicateCases::Side, 2);
    vtkShaderProgram* program =
      error.empty() ? this->Draw.use(this->Window, "passes/full_view.vert.glsl",
                        "passes/predicate_check.frag.glsl", key.filtered().defines(), error)
                    : nullptr;
    if (program)
    {
      this->Uploaded.texture()->Activate();
      program->SetUniformi("caseTexture", this->Uploaded.texture()->GetTextureUnit());
      program->SetUniformi("turns", 3);
      this->Draw.drawTriangles(1);
      this->Uploaded.texture()->Deactivate();
    }
    return error;
  }

  vtkOpenGLRenderWindow* Window;
  PredicateCases Cases;
  UploadedImage Uploaded;
  FloatTarget Answers;
  ShaderDraw Draw;
};

} // namespace

std::string findPredicate(vtkOpenGLRenderWindow* window, bool& fused)
{
  Check check(window);
  int wrongFused = 0;
  fused =
    hasExtension("GL_ARB_gpu_shader5") && check.run(true, wrongFused).empty() && wrongFused == 0;
  if (fused)
  {
    return {};
  }
  int wrong = 0;
  const std::string error = check.run(false, wrong);
  if (!error.empty() || wrong == 0)
  {
    return error;
  }
  return "The shaders of this GL round where they must not: of " +
         std::to_string(PredicateCases::Count) +
         " cases that tell on which side of a ray an edge lies, " + std::to_string(wrong) +
         " are wrong or differ from place to place. Rays would get lost among the tetrahedra, so "
         "nothing is drawn. Update the graphics driver, or draw by Mesa's software renderer "
         "(LIBGL_ALWAYS_SOFTWARE=1 in the environment).";
}

} // namespace tetmarch
