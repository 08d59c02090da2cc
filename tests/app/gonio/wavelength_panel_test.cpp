// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/wavelength_panel.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QTest>

#include "core/rgl/rgl_edit.h"
#include "core/rgl/rgl_file.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/function_brdf.h"
#include "tests/support/spectral_file.h"
#include "tests/support/test_program.h"
#include "widgets/inputs/parameter_slider.h"

namespace wavelength_panel_test {
using namespace gonio;
using namespace gonio::app;
using test_support::patienceMilliseconds;

LoadedMaterialPtr spectralMaterial() {
  const std::vector<std::byte> bytes = test::spectral::spectralFile();
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = "spectral";
  loaded->material.brdf = loaded->base = rgl::readRgl(io::MemorySource(bytes)).brdf;
  return loaded;
}

LoadedMaterialPtr table() {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.brdf = loaded->base = bakeTable(*test::ggx(Rgb(0.2), Rgb(0.8), 0.3, 0.5), {12, 12, 12});
  return loaded;
}

editing::EditList darker() {
  const models::Model& model = models::findModel("lambert");
  models::ParameterValues before = models::defaultParameters(model.spec()), after = before;
  before.values[0] = Rgb(0.1);
  after.values[0] = Rgb(0.5, 0.4, 0.3);
  return {{editing::DifferentialEdit{&model, before, after, editing::Composition::additive}}};
}

const DirectionPair pair{fromSpherical(0.3, 0.2), fromSpherical(0.6, 1)};
double valueOf(const widgets::PreviewSubject& subject) {
  const Rgb value = widgets::subjectBrdf(subject)->evaluate(pair.wi, pair.wo);
  return value.x == value.y && value.y == value.z ? value.x : -1;
}

class WavelengthPanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void onlySpectralMaterialsHaveIt() {
    Document document;
    BackgroundTasks tasks;
    WavelengthPanel panel(document, tasks);
    QVERIFY(panel.isHidden());
    document.setMaterial(spectralMaterial());
    QVERIFY(!panel.isHidden() && !panel.subjects());
    document.setMaterial(table());
    QVERIFY(panel.isHidden());
  }

  /// The file's values at the slider's wavelength, in grey, beside the edited ones; no step of the document.
  void followsSliderAndEdits() {
    Document document;
    BackgroundTasks tasks;
    WavelengthPanel panel(document, tasks);
    QSignalSpy changed(&panel, &WavelengthPanel::subjectsChanged);
    document.setMaterial(spectralMaterial());
    choose(panel, 1);
    QTRY_VERIFY_WITH_TIMEOUT(panel.subjects(), patienceMilliseconds);
    Q_EMIT panel.slider().numberEdited(610);
    QTRY_VERIFY_WITH_TIMEOUT(panel.subjects()->nanometres == 610, patienceMilliseconds);
    QCOMPARE(document.history().count(), 0);
    const RglBrdf& file = *formOf<RglBrdf>(*document.material()->base);
    const double stored = rgl::atWavelength(file, nullptr, 610)->evaluate(pair.wi, pair.wo).x;
    QVERIFY(stored > 0);
    QCOMPARE(valueOf(panel.subjects()->measured), stored);
    QCOMPARE(valueOf(panel.subjects()->edited), stored);
    document.installEdits(darker(), "darker");
    QTRY_VERIFY_WITH_TIMEOUT(panel.isSettled() && valueOf(panel.subjects()->edited) != stored, patienceMilliseconds);
    QCOMPARE(valueOf(panel.subjects()->measured), stored);
    const auto edited = editing::applyEdits(document.base(), document.edits());
    const auto expected = rgl::atWavelength(file, edited.get(), 610);
    QCOMPARE(valueOf(panel.subjects()->edited), expected->evaluate(pair.wi, pair.wo).x);
    choose(panel, 0);
    QVERIFY(!panel.subjects() && panel.isSettled());
  }

  /// A wavelength of one material is never shown for the next.
  void anotherMaterialStartsWithAll() {
    Document document;
    BackgroundTasks tasks;
    WavelengthPanel panel(document, tasks);
    document.setMaterial(spectralMaterial());
    choose(panel, 1);
    QTRY_VERIFY_WITH_TIMEOUT(panel.subjects(), patienceMilliseconds);
    document.setMaterial(spectralMaterial());
    QVERIFY(!panel.subjects() && panel.choice().currentIndex() == 0);
  }

 private:
  static void choose(WavelengthPanel& panel, int index) {
    panel.choice().setCurrentIndex(index);
    Q_EMIT panel.choice().activated(index);
  }
};

GONIO_TEST(WavelengthPanelTest)

}  // namespace wavelength_panel_test

#include "wavelength_panel_test.moc"
