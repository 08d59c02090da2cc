// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/parameter_panel.h"
#include "tests/widgets/child.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "core/models/registry.h"
#include "tests/support/test_program.h"
#include "widgets/inputs/collapsible_section.h"
#include "widgets/parameters/colour_swatch.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_line.h"
#include "widgets/parameters/parameter_row.h"
#include "widgets/parameters/parameter_text.h"

namespace parameter_panel_test {
using namespace gonio;
using namespace gonio::widgets;

class ParameterPanelTest : public QObject {
  Q_OBJECT
 private:
  const models::ModelSpec& m_spec = models::ggx().spec();
  std::size_t index(const char* id) const { return *m_spec.find(id); }
  static ParameterLine* line(const ParameterRow* row, int n) { return row->findChildren<ParameterLine*>().at(n); }

  static QToolButton* resetButton(const ParameterLine* line) {
    for (QToolButton* button : line->findChildren<QToolButton*>())
      if (button->accessibleName().startsWith("Reset")) return button;
    return nullptr;
  }

  /// A panel whose owner takes every value, as the document does.
  struct Owned {
    ParameterPanel panel;
    models::ParameterValues values, fitted;
    int started = 0, finished = 0;

    explicit Owned(const models::ModelSpec& spec) : values(models::defaultParameters(spec)), fitted(values) {
      panel.setModel(&spec);
      panel.setValues(values, fitted);
      connect(&panel, &ParameterPanel::editingStarted, &panel, [this] { ++started; });
      connect(&panel, &ParameterPanel::editingFinished, &panel, [this] { ++finished; });
      connect(&panel, &ParameterPanel::valueEdited, &panel, [this](int parameter, const Rgb& value) {
        values.values[std::size_t(parameter)] = value;
        panel.setValues(values, fitted);
      });
      connect(&panel, &ParameterPanel::resetRequested, &panel, [this](int parameter) {
        values.values[std::size_t(parameter)] = fitted.values[std::size_t(parameter)];
        panel.setValues(values, fitted);
      });
    }
  };

 private Q_SLOTS:
  /// As a square root, roughness is shown, typed and explained so; the value stays that of the model.
  void roughnessAsASquareRoot() {
    Owned owned(m_spec);
    const std::size_t roughness = index("roughness");
    const NumberField& field = *line(owned.panel.row(roughness), 0)->field();
    owned.values.values[roughness] = Rgb(0.25);
    owned.panel.setValues(owned.values, owned.fitted);
    QCOMPARE(field.text(), "0.25");
    setRoughnessDisplay(RoughnessDisplay::squareRoot);
    owned.panel.showUnits();
    QCOMPARE(field.text(), "0.5");
    QVERIFY(field.toolTip().contains("√α"));
    QCOMPARE(owned.values.values[roughness].x, 0.25);
    auto* typed = line(owned.panel.row(roughness), 0)->field();
    typed->selectAll();
    QTest::keyClicks(typed, "0.8");
    QTest::keyClick(typed, Qt::Key_Return);
    QVERIFY(std::abs(owned.values.values[roughness].x - 0.64) < 1e-12);
    typed->selectAll();
    QTest::keyClicks(typed, "-1");
    QTest::keyClick(typed, Qt::Key_Return);
    QCOMPARE(owned.values.values[roughness].x, m_spec.parameters[roughness].hardMin);
    // Oren and Nayar's is an angle.
    const models::ModelSpec& orenNayar = models::findModel("oren-nayar").spec();
    QCOMPARE(displayUnit(orenNayar.parameters[*orenNayar.find("roughness")]), "°");
    setRoughnessDisplay(RoughnessDisplay::alpha);
  }

  /// A fit may lead outside the range that an artist uses: the slider spans it, four fifths of the way, within what
  /// can be typed; where the fit lies inside, the range stays.
  void slidersHoldTheFittedValue() {
    for (const models::Model* model : models::allModels())
      for (const models::ParameterSpec& spec : model->spec().parameters) {
        QVERIFY((sliderRange(spec, spec.softMin) == std::pair{spec.softMin, spec.softMax}));
        QVERIFY((sliderRange(spec, spec.softMax) == std::pair{spec.softMin, spec.softMax}));
        for (const double fraction : {0.01, 0.5, 1.0}) {
          const double above = std::lerp(spec.softMax, spec.hardMax, fraction);
          const auto [low, high] = sliderRange(spec, above);
          QVERIFY(low == spec.softMin && high >= above && high <= spec.hardMax);
          const double below = std::lerp(spec.softMin, spec.hardMin, fraction);
          const auto [least, most] = sliderRange(spec, below);
          QVERIFY(most == spec.softMax && least <= below && least >= spec.hardMin);
        }
      }
    Owned owned(m_spec);
    const std::size_t i = index("diffuse");
    owned.values.values[i] = owned.fitted.values[i] = Rgb(2);  // soft range 0 to 1, hard range to 10
    owned.panel.setValues(owned.values, owned.fitted);
    ParameterSlider* slider = line(owned.panel.row(i), 0)->slider();
    QSignalSpy edited(slider, &ParameterSlider::numberEdited);
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_End);
    QCOMPARE(edited.last()[0].toDouble(), 2.5);
  }

  /// What matters only with another choice is grey and says why; it wakes when that choice is made.
  void inactiveParametersAreGrey() {
    for (const models::Model* model : models::allModels()) {
      Owned owned(model->spec());
      for (std::size_t i = 0; i < model->spec().parameters.size(); ++i) {
        const models::ParameterSpec& spec = model->spec().parameters[i];
        if (spec.activeWith.empty()) {
          QVERIFY(owned.panel.row(i)->isEnabled());
          continue;
        }
        const std::size_t choice = *model->spec().find(spec.activeWith);
        for (std::size_t c = 0; c < model->spec().parameters[choice].choices.size(); ++c) {
          owned.values.values[choice] = Rgb(double(c));
          owned.panel.setValues(owned.values, owned.fitted);
          QCOMPARE(owned.panel.row(i)->isEnabled(), int(c) == spec.activeChoice);
          const QString toolTip = line(owned.panel.row(i), 0)->slider()->toolTip();
          QCOMPARE(toolTip.contains("an effect only"), int(c) != spec.activeChoice);
        }
      }
    }
  }

  /// Dozens of coefficients are folded at first; what was unfolded stays so with the next model.
  void coefficientsAreFolded() {
    const models::ModelSpec& spec = models::findModel("spherical-harmonics").spec();
    std::size_t coefficient = 0;
    while (spec.parameters[coefficient].group != models::ParameterGroup::coefficients) ++coefficient;
    Owned owned(spec);
    owned.panel.show();
    QVERIFY(!owned.panel.row(coefficient)->isVisible());
    auto* section = owned.panel.findChild<CollapsibleSection*>();
    section->setExpanded(true);
    QVERIFY(owned.panel.row(coefficient)->isVisible());
    owned.panel.setModel(&m_spec);
    owned.panel.setModel(&spec);
    QTRY_VERIFY(owned.panel.row(coefficient)->isVisible());
  }

  void everyModelHasARowForEveryParameter() {
    for (const models::Model* model : models::allModels()) {
      Owned owned(model->spec());
      QCOMPARE(owned.panel.rowCount(), model->spec().parameters.size());
      for (const auto* slider : owned.panel.findChildren<ParameterSlider*>())
        QVERIFY(!slider->accessibleName().isEmpty());
      for (const auto* field : owned.panel.findChildren<NumberField*>()) QVERIFY(!field->accessibleName().isEmpty());
      for (const auto* button : owned.panel.findChildren<QToolButton*>()) QVERIFY(!button->accessibleName().isEmpty());
    }
  }

  void keysOnASliderEditAndBackspaceResets() {
    Owned owned(m_spec);
    const std::size_t roughness = index("roughness");
    ParameterLine* row = line(owned.panel.row(roughness), 0);
    QTest::keyClick(row->slider(), Qt::Key_PageUp);
    QVERIFY(owned.values.values[roughness].x > owned.fitted.values[roughness].x);
    QVERIFY(owned.values.values[roughness] == Rgb(owned.values.values[roughness].x));
    QCOMPARE(owned.started, 1);
    QCOMPARE(owned.finished, 1);
    QVERIFY(row->isModified());
    QVERIFY(row->label()->font().bold());
    QVERIFY(!resetButton(row)->isHidden());
    QTest::keyClick(row->slider(), Qt::Key_Backspace);
    QVERIFY(owned.values == owned.fitted);
    QVERIFY(!row->isModified());
    QVERIFY(resetButton(row)->isHidden());
  }

  void typingReachesTheHardRange() {
    Owned owned(m_spec);
    const std::size_t specular = index("specular");
    NumberField* field = line(owned.panel.row(specular), 0)->field();
    field->selectAll();
    QTest::keyClicks(field, "25*2");
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(owned.values.values[specular] == Rgb(50));
  }

  void doubleClickOnTheLabelResets() {
    Owned owned(m_spec);
    const std::size_t f0 = index("f0");
    owned.values.values[f0] = Rgb(0.5);
    owned.panel.setValues(owned.values, owned.fitted);
    QTest::mouseDClick(line(owned.panel.row(f0), 0)->label(), Qt::LeftButton);
    QVERIFY(owned.values == owned.fitted);
  }

  void theLinkedSliderKeepsTheTint() {
    Owned owned(m_spec);
    const std::size_t diffuse = index("diffuse");
    owned.values.values[diffuse] = Rgb(0.4, 0.2, 0.1);
    owned.panel.setValues(owned.values, owned.fitted);
    NumberField* field = line(owned.panel.row(diffuse), 0)->field();
    field->selectAll();
    QTest::keyClicks(field, "0.5");
    QTest::keyClick(field, Qt::Key_Return);
    const Rgb value = owned.values.values[diffuse];
    QVERIFY(qAbs(luminance(value) - 0.5) < 1e-12);
    QVERIFY(qAbs(value.x / value.y - 2) < 1e-12 && qAbs(value.y / value.z - 2) < 1e-12);
  }

  void aChannelIsEditedAlone() {
    Owned owned(m_spec);
    const std::size_t diffuse = index("diffuse");
    ParameterRow* row = owned.panel.row(diffuse);
    QVERIFY(line(row, 2)->isHidden());
    test::child<QToolButton>(*row, "Channels of " + toQString(row->spec().label))->click();
    QVERIFY(!line(row, 2)->isHidden());
    QVERIFY(row->findChild<ColourSwatch*>());
    const Rgb before = owned.values.values[diffuse];
    QTest::keyClick(line(row, 2)->slider(), Qt::Key_End);
    QVERIFY(owned.values.values[diffuse] == Rgb(before.x, 1, before.z));
    QTest::mouseClick(resetButton(line(row, 2)), Qt::LeftButton);
    QVERIFY(owned.values == owned.fitted);
  }

  void choicesAreLists() {
    Owned owned(m_spec);
    const std::size_t masking = index("masking");
    auto* list = owned.panel.row(masking)->findChild<QComboBox*>();
    QVERIFY(list);
    QCOMPARE(list->count(), int(m_spec.parameters[masking].choices.size()));
    QTest::keyClick(list, Qt::Key_Down);
    QVERIFY(owned.values.values[masking] == Rgb(1));
  }

  void toolTipsTellTheSpec() {
    const models::ParameterSpec& roughness = m_spec.parameters[index("roughness")];
    const Rgb fitted(0.25);
    const QString text = parameterToolTip(roughness, &fitted);
    for (const auto& part : {roughness.label, roughness.description, roughness.reference})
      QVERIFY(text.contains(toQString(part).toHtmlEscaped()));
    for (const auto& part : {roughness.symbol, roughness.formula}) QVERIFY(text.contains(formulaHtml(part)));
    QVERIFY(text.contains("0.25"));
  }

  void linkedValues() {
    models::ParameterSpec spec = m_spec.parameters[index("diffuse")];
    QVERIFY(withLinkedValue(spec, Rgb(0), 0.5) == Rgb(0.5));    // black has no tint
    QVERIFY(withLinkedValue(spec, Rgb(0.3), 0.7) == Rgb(0.7));  // grey stays exactly grey
    QVERIFY(linkedValue(spec, Rgb(0.3)) == 0.3);
    spec.hardMin = -1;
    const Rgb shifted = withLinkedValue(spec, Rgb(-0.1, 0, 0.1), 0.2);
    QVERIFY(qAbs(shifted.x - 0.1) < 1e-12 && qAbs(shifted.z - 0.3) < 1e-12);
  }

  void withoutAModelThereAreNoRows() {
    ParameterPanel panel;
    QCOMPARE(panel.rowCount(), std::size_t(0));
    QCOMPARE(panel.currentParameter(), -1);
  }
};

GONIO_TEST(ParameterPanelTest)
}  // namespace parameter_panel_test

#include "parameter_panel_test.moc"
