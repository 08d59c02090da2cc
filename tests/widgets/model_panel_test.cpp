// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/model_panel.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <set>

#include "tests/support/test_program.h"

namespace model_panel_test {
using namespace gonio;

class ModelPanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Every model stands once under its family's title, which cannot be chosen; choosing reports the model of the entry.
  void modelsByFamily() {
    widgets::ModelPanel panel;
    auto* list = panel.findChild<QComboBox*>();
    const models::Model* chosen = nullptr;
    connect(&panel, &widgets::ModelPanel::modelChosen, this, [&](const models::Model* model) { chosen = model; });
    std::set<const models::Model*> seen;
    QList<int> families;
    int titles = 0;
    for (int i = 0; i < list->count(); ++i) {
      if (!(list->model()->index(i, 0).flags() & Qt::ItemIsEnabled)) {
        ++titles;
        continue;
      }
      Q_EMIT list->activated(i);
      QVERIFY(chosen);
      QCOMPARE(list->itemText(i), QString::fromUtf8(chosen->spec().name.data(), qsizetype(chosen->spec().name.size())));
      QVERIFY(seen.insert(chosen).second);
      families << int(chosen->spec().family);
    }
    QCOMPARE(seen.size(), models::allModels().size());
    QCOMPARE(titles, 3);
    QVERIFY(std::is_sorted(families.begin(), families.end()));
  }

  void theModelInUseIsShown() {
    widgets::ModelPanel panel;
    auto* list = panel.findChild<QComboBox*>();
    QCOMPARE(list->currentIndex(), -1);
    for (const models::Model* model : models::allModels()) {
      panel.setModel(model);
      QVERIFY(list->currentText() ==
              QString::fromUtf8(model->spec().name.data(), qsizetype(model->spec().name.size())));
    }
    panel.setModel(nullptr);
    QCOMPARE(list->currentIndex(), -1);
  }
};

GONIO_TEST(ModelPanelTest)
}  // namespace model_panel_test

#include "model_panel_test.moc"
