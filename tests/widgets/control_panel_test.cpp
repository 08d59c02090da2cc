// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/control_panel.h"

#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "core/models/registry.h"
#include "tests/support/test_program.h"
#include "widgets/parameters/parameter_line.h"
#include "widgets/parameters/parameter_row.h"

namespace control_panel_test {
using namespace gonio;
using namespace gonio::widgets;
using editing::ArtistControl;

class ControlPanelTest : public QObject {
  Q_OBJECT
 private:
  static editing::DifferentialEdit editOf(const models::Model& model) {
    editing::DifferentialEdit edit;
    edit.model = &model;
    edit.fitted = edit.edited = models::defaultParameters(model.spec());
    return edit;
  }
  static ParameterLine* line(const ParameterRow* row) { return row->findChild<ParameterLine*>(); }
  /// What a control changes.
  static QString changesText(const ControlPanel& panel, ArtistControl control) { return panel.changes(control); }
  /// Null if there is none.
  static const ParameterRow* diffuseRow(const ControlPanel& panel) {
    for (const ParameterRow* row : panel.findChildren<ParameterRow*>())
      if (row->spec().label == "Diffuse colour") return row;
    return nullptr;
  }

 private Q_SLOTS:
  void withoutAnEditItSaysWhy() {
    ControlPanel panel;
    panel.setEdit(nullptr, QStringLiteral("Open a material to edit it."));
    QVERIFY(!panel.row(ArtistControl::roughness));
    QCOMPARE(panel.findChild<QLabel*>("hint")->text(), QStringLiteral("Open a material to edit it."));
    const editing::DifferentialEdit edit = editOf(models::ggx());
    panel.setEdit(&edit);
    QVERIFY(panel.row(ArtistControl::roughness));
    panel.setEdit(nullptr);
    QVERIFY(!panel.row(ArtistControl::roughness) && !diffuseRow(panel));
  }

  /// What a control does appears below all of them: no row moves, neither under the hand nor after it.
  void rowsKeepTheirPlacesWhileASliderIsDragged() {
    ControlPanel panel;
    editing::DifferentialEdit edit = editOf(models::ggx());
    panel.setEdit(&edit);
    panel.resize(300, 500);
    panel.show();
    ParameterRow* roughness = panel.row(ArtistControl::roughness);
    const int before = panel.row(ArtistControl::contrast)->mapTo(&panel, QPoint()).y();
    const auto place = [&] {
      QApplication::processEvents();
      return panel.row(ArtistControl::contrast)->mapTo(&panel, QPoint()).y();
    };
    Q_EMIT roughness->editingStarted();
    edit.controls.values[std::size_t(ArtistControl::roughness)] = Rgb(2);
    panel.setEdit(&edit);
    QCOMPARE(place(), before);
    QVERIFY(!changesText(panel, ArtistControl::roughness).isEmpty());
    Q_EMIT roughness->editingFinished();
    QCOMPARE(place(), before);
    QCOMPARE(panel.findChild<QLabel*>("changes")->text(), changesText(panel, ArtistControl::roughness));
  }

  void whatTheModelDoesNotHaveIsGreyAndSaysSo() {
    ControlPanel panel;
    const editing::DifferentialEdit edit = editOf(models::ggx());
    panel.setEdit(&edit);
    for (std::size_t i = 0; i < editing::artistControls().parameters.size(); ++i)
      QCOMPARE(panel.row(ArtistControl(i))->isEnabled(), editing::actsOn(ArtistControl(i), models::ggx().spec()));
    QVERIFY(!panel.row(ArtistControl::coatStrength)->isEnabled());
    QVERIFY(line(panel.row(ArtistControl::coatStrength))->label()->toolTip().contains("Layered lobes"));
    const editing::DifferentialEdit layered = editOf(models::layered());
    panel.setEdit(&layered);
    QVERIFY(panel.row(ArtistControl::coatStrength)->isEnabled());
  }

  /// Lines of any length would push the other sliders out of sight.
  void manyChangesAreNamedInTheTooltip() {
    ControlPanel panel;
    editing::DifferentialEdit edit = editOf(models::findModel("dsbrdf"));
    edit.controls.values[0] = Rgb(2);
    panel.setEdit(&edit);
    const QString text = changesText(panel, ArtistControl::roughness);
    QCOMPARE(text.count(QChar(0x2192)), 2);
    QVERIFY(text.endsWith(" more"));
    const auto labels = panel.findChildren<QLabel*>();
    const auto shown = std::ranges::find(labels, text, &QLabel::text);
    QVERIFY(shown != labels.end());
    QVERIFY((*shown)->toolTip().count(QChar(0x2192)) > 2);
  }

  void aLimitIsNamed() {
    ControlPanel panel;
    editing::DifferentialEdit edit = editOf(models::ggx());
    for (const auto& [factor, expected] : {std::pair(8.0, "Roughness 0.3 \u2192 1 (maximum)"),
                                           std::pair(1e-4, "Roughness 0.3 \u2192 0.0001 (minimum)")}) {
      edit.controls.values[std::size_t(ArtistControl::roughness)] = Rgb(factor);
      panel.setEdit(&edit);
      QCOMPARE(changesText(panel, ArtistControl::roughness), QString::fromUtf8(expected));
    }
  }

  /// A step of the slider is offered, and what the owner made of it is shown with the parameters that it changed.
  void aMovedControlStatesWhatItDid() {
    ControlPanel panel;
    editing::DifferentialEdit edit = editOf(models::ggx());
    panel.setEdit(&edit);
    int started = 0, finished = 0;
    connect(&panel, &ControlPanel::editingStarted, &panel, [&] { ++started; });
    connect(&panel, &ControlPanel::editingFinished, &panel, [&] { ++finished; });
    connect(&panel, &ControlPanel::controlEdited, &panel, [&](ArtistControl control, const Rgb& value) {
      edit.controls.values[std::size_t(control)] = value;
      panel.setEdit(&edit);
    });
    QVERIFY(changesText(panel, ArtistControl::roughness).isEmpty());
    NumberField* field = line(panel.row(ArtistControl::roughness))->field();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "2");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(edit.controls.values[0].x, 2.0);
    QVERIFY(started == 1 && finished == 1);
    QCOMPARE(changesText(panel, ArtistControl::roughness), QString::fromUtf8("Roughness 0.3 \u2192 0.6"));
    QVERIFY(panel.row(ArtistControl::roughness)->isModified());
    QVERIFY(changesText(panel, ArtistControl::tint).isEmpty());
  }

  void theBodyIsTheModelsOwnParameter() {
    ControlPanel panel;
    const editing::DifferentialEdit edit = editOf(models::ggx());
    panel.setEdit(&edit);
    int parameter = -1;
    Rgb value(0);
    connect(&panel, &ControlPanel::diffuseEdited, &panel, [&](int index, const Rgb& colour) {
      parameter = index;
      value = colour;
    });
    Q_EMIT line(diffuseRow(panel))->valueEdited(0.5);
    QCOMPARE(parameter, int(*models::ggx().spec().find("diffuse")));
    QVERIFY(value == Rgb(0.5));
    const editing::DifferentialEdit without = editOf(models::findModel("rational"));
    panel.setEdit(&without);
    QVERIFY(!diffuseRow(panel));
  }
};

GONIO_TEST(ControlPanelTest)
}  // namespace control_panel_test

#include "control_panel_test.moc"
