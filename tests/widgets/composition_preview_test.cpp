// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "core/models/model.h"
#include "core/models/registry.h"
#include "core/rgl/rgl_file.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_spheres.h"

namespace composition_preview_test {
using namespace gonio;
using editing::Composition;
namespace fs = std::filesystem;

/// A model's edit of its roughness from one value to another, and of the colour of its highlight.
editing::Edit edit(const char* id, const char* roughness, const char* colour, Composition composition, double from,
                   double to) {
  const models::Model& model = models::findModel(id);
  editing::DifferentialEdit edit{
      .model = &model, .fitted = models::defaultParameters(model.spec()), .composition = composition};
  edit.fitted.values[*model.spec().find(roughness)] = Rgb(from);
  edit.edited = edit.fitted;
  edit.edited.values[*model.spec().find(roughness)] = Rgb(to);
  edit.edited.values[*model.spec().find(colour)] *= Rgb(1.5, 1, 0.5);
  return {.content = edit, .strength = 0.9};
}

editing::Edit ofGgx(Composition composition, double from, double to) {
  return edit("ggx", "roughness", "specular", composition, from, to);
}
/// With all lobes that there are, the sheen and the retroreflection brighter.
editing::Edit ofLayers(Composition composition, double from, double to) {
  editing::Edit result = edit("layered", "coat-roughness", "flakes", composition, from, to);
  auto& change = std::get<editing::DifferentialEdit>(result.content);
  const auto set = [&](const char* id, double fitted, double edited) {
    const std::size_t parameter = *change.model->spec().find(id);
    change.fitted.values[parameter] = Rgb(fitted);
    change.edited.values[parameter] = Rgb(edited);
  };
  for (const char* lobe : {"sheen-lobe", "retro-lobe"}) set(lobe, 1, 1);
  set("sheen", 0.1, 0.2);
  set("retro", 0.05, 0.1);
  return result;
}

/// Of both widths along a grain, which turns.
editing::Edit ofGrain(const models::Model& model) {
  editing::DifferentialEdit edit{
      .model = &model, .fitted = models::defaultParameters(model.spec()), .composition = Composition::lobes};
  edit.edited = edit.fitted;
  const auto set = [&](const char* id, double fitted, double edited) {
    if (const auto i = model.spec().find(id)) {
      edit.fitted.values[*i] = Rgb(fitted);
      edit.edited.values[*i] = Rgb(edited);
    }
  };
  set("roughness-x", 0.15, 0.3);
  set("roughness-y", 0.4, 0.3);
  set("exponent-x", 90, 25);
  set("exponent-y", 12, 25);
  set("rotation", 0.3, 0.8);
  return {.content = edit, .strength = 0.9};
}

editing::Edit keepingAlbedo(editing::Edit edit) {
  std::get<editing::DifferentialEdit>(edit.content).keepsAlbedo = true;
  return edit;
}

/// Two highlights of GGX lobes; a fit of one leaves a peak.
std::shared_ptr<const TabulatedBrdf> twoHighlights() {
  const models::Model& model = models::layered();
  models::ParameterValues values = models::defaultParameters(model.spec());
  for (const auto& [id, value] : {std::pair{"base-roughness", 0.4},
                                  {"coat-roughness", 0.03},
                                  {"base", 0.2},
                                  {"flakes", 0.0},
                                  {"flakes-edge", 0.0}})
    values.values[*model.spec().find(id)] = Rgb(value);
  return bakeTable(*model.instantiate(values));
}

std::shared_ptr<const TabulatedBrdf> measuredTable() {
  const models::Model& model = models::findModel("abc");
  return bakeTable(*model.instantiate(models::defaultParameters(model.spec())));
}

/// Every composition in the shader is that of editing::applyEdits().
class CompositionPreviewTest : public test::SphereTest {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    openSpheres();
    table_ = measuredTable();
  }

  void overATable() {
    for (const Composition composition : {Composition::additive, Composition::logPlus, Composition::lobes})
      for (const auto& [from, to] : {std::pair{0.1, 0.4}, {0.3, 0.1}}) {
        verify(table_, {ofGgx(composition, from, to)});
        verify(table_, {ofLayers(composition, from, to)});
      }
  }

  void byModelsWithAGrain() {
    const models::Model& ward = models::findModel("ward-anisotropic");
    models::ParameterValues grain = models::defaultParameters(ward.spec());
    grain.values[*ward.spec().find("roughness-y")] = Rgb(0.5);
    const auto brushed = std::make_shared<const models::ModelBrdf>(ward, grain);
    verify(brushed, {ofGrain(models::findModel("ggx-anisotropic"))});
    for (const char* model : {"ward-anisotropic", "ashikhmin-shirley"})
      verify(table_, {ofGrain(models::findModel(model))});
  }

  /// What the text of a lobe depends on: which parts there are, and what changes of them.
  void partsThatComeAndGo() {
    const models::Model& model = models::layered();
    for (const auto& [from, to] : {std::pair{0.0, 1.0}, {1.0, 0.0}}) {
      editing::Edit edit = ofLayers(Composition::lobes, 0.2, 0.2);
      auto& change = std::get<editing::DifferentialEdit>(edit.content);
      for (const char* part : {"coat-lobe", "retro-lobe", "diffuse"}) {
        change.fitted.values[*model.spec().find(part)] *= Rgb(from);
        change.edited.values[*model.spec().find(part)] *= Rgb(to);
      }
      for (const char* width : {"base-roughness", "flakes-roughness"})
        change.edited.values[*model.spec().find(width)] *= Rgb(width[0] == 'b' ? 0.7 : 0.5);
      verify(table_, {edit});
    }
  }

  void coloursOfTheValues() {
    for (const auto& [from, to] : {std::pair{0.2, 0.2}, {0.2, 0.3}}) {
      editing::Edit edit = ofGgx(Composition::lobes, from, to);
      auto& controls = std::get<editing::DifferentialEdit>(edit.content).controls;
      controls.values[std::size_t(editing::ArtistControl::tint)] = Rgb(0.9, 0.4, 1);
      controls.values[std::size_t(editing::ArtistControl::saturation)] = Rgb(1.8);
      verify(table_, {edit, ofGgx(Composition::additive, 0.2, 0.25)});
    }
  }

  /// An edit by lobes asks the edits before it for other directions; what follows it looks at its result.
  void inStacks() {
    const editing::Edit lobes = ofLayers(Composition::lobes, 0.1, 0.3), others = ofGgx(Composition::logPlus, 0.2, 0.3);
    verify(table_, {others, lobes});
    verify(table_, {lobes, others});
    verify(table_, {lobes, others, ofGgx(Composition::lobes, 0.2, 0.15)});
  }

  /// Peaks that the fit does not explain, and the factor of the albedo; with lobes that change and others that do not.
  void keptAlbedo() {
    const auto base = twoHighlights();
    for (const auto& [from, to] : {std::pair{0.15, 0.5}, {0.15, 0.1}}) {
      verify(base, {keepingAlbedo(ofGgx(Composition::lobes, from, to))});
      verify(base, {keepingAlbedo(ofLayers(Composition::lobes, from, to))});
    }
    verify(base, {ofGgx(Composition::logPlus, 0.2, 0.3), keepingAlbedo(ofGgx(Composition::lobes, 0.15, 0.5))});
    verify(base, {keepingAlbedo(ofGgx(Composition::lobes, 0.2, 0.2))});  // its colour alone
    const auto grain = [](const char* id) { return keepingAlbedo(ofGrain(models::findModel(id))); };
    verify(base, {grain("ggx-anisotropic")});
    verify(base, {grain("ashikhmin-shirley")});
  }

  void overAnRglFile() {
    const fs::path path = fs::path(GONIO_SHARED_DIR) / "data/rgl/vch_golden_yellow_rgb.bsdf";
    if (!fs::exists(path)) QSKIP("the development data is absent");
    const auto brdf = rgl::readRgl(io::FileSource(path)).brdf;
    verify(brdf, {ofLayers(Composition::lobes, 0.1, 0.2)});
    verify(brdf, {keepingAlbedo(ofLayers(Composition::lobes, 0.1, 0.2))});
    verify(brdf, {ofLayers(Composition::logPlus, 0.1, 0.2)});
  }

 private:
  void verify(const std::shared_ptr<const Brdf>& base, const editing::EditList& edits) {
    SphereTest::verify({widgets::EditedMaterial{base, edits}});
  }

  std::shared_ptr<const TabulatedBrdf> table_;
};

GONIO_TEST(CompositionPreviewTest)
}  // namespace composition_preview_test

#include "composition_preview_test.moc"
