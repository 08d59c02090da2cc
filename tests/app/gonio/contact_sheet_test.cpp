// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/contact_sheet_window.h"

#include <QSignalSpy>
#include <QTest>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/study/fit_ranking_model.h"
#include "app/gonio/study/sheet_sources.h"
#include "core/models/registry.h"
#include "core/study/accuracy_study.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"

namespace contact_sheet_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

bool wait(const std::function<bool()>& done) { return QTest::qWaitFor(done, patienceMilliseconds); }

class ContactSheetTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    material_ = glossyMaterial(0.3, HalfDifferenceGrid{20, 20, 20});
    study::RankingOptions options;
    for (const char* id : {"lambert", "ggx", "blinn-phong"}) options.models.push_back(&models::findModel(id));
    for (const study::RankedFit& ranked : study::rankFits({material_->table(), material_->material.brdf}, options))
      ranking_.add(ranked);
    QCOMPARE(ranking_.rowCount(), 3);
  }

  /// The material first, then the best; pictures and maps of all on one scale; fewer where fewer are asked for.
  void showsTheBestFirst() {
    BackgroundTasks tasks;
    ContactSheetWindow window(tasks, sheetSource("acrylic", material_, ranking_), nullptr);
    QVERIFY(wait([&] { return window.isComplete(); }));
    const auto& tiles = window.sheet().tiles();
    QCOMPARE(tiles.size(), std::size_t(4));
    QVERIFY(tiles[0].map.isNull() && !tiles[0].picture.isNull());
    QCOMPARE(tiles[1].name, QString("GGX"));
    for (std::size_t i = 1; i < tiles.size(); ++i) {
      QVERIFY(!tiles[i].picture.isNull() && tiles[i].map.size() == tiles[i].picture.size());
      QVERIFY(tiles[i].numbers.contains(" dB"));
    }
    window.setCount(2);
    QVERIFY(wait([&] { return window.isComplete() && window.sheet().tiles().size() == 3; }));
    const QImage narrow = window.sheet().picture(64, 1), wide = window.sheet().picture(64, 3);
    QVERIFY(narrow.height() > 2 * wide.height() && wide.width() > 2 * narrow.width());
  }

  /// Only what is shown is rendered, the rest when it is asked for.
  void rendersWhatIsShown() {
    BackgroundTasks tasks;
    ContactSheetWindow window(tasks, sheetSource("acrylic", material_, ranking_), nullptr);
    window.setCount(1);
    QVERIFY(wait([&] { return window.isComplete() && tasks.isIdle(); }));
    window.setCount(3);
    QVERIFY(!window.isComplete() && !tasks.isIdle());
    QVERIFY(window.sheet().tiles()[3].picture.isNull());
    QVERIFY(wait([&] { return window.isComplete() && tasks.isIdle(); }));
    for (const widgets::SheetTile& tile : window.sheet().tiles()) QVERIFY(!tile.picture.isNull());
  }

  /// Two tiles go to the preview: the material in its native form and the model alone.
  void comparesTwo() {
    BackgroundTasks tasks;
    ContactSheetWindow window(tasks, sheetSource("acrylic", material_, ranking_), nullptr);
    QSignalSpy compare(&window, &ContactSheetWindow::compareRequested);
    window.sheet().toggle(2);
    window.sheet().toggle(1);
    window.sheet().toggle(0);
    QCOMPARE(window.sheet().selected(), std::vector<int>({1, 0}));
    window.compareSelected();
    QVERIFY(wait([&] { return compare.count() == 1; }));
    const auto subjects = compare[0][0].value<std::array<widgets::PreviewSubject, 2>>();
    QVERIFY(std::holds_alternative<widgets::StandaloneModel>(subjects[0].shown));
    QVERIFY(subjects[1].isMeasured() && subjects[1].base() == material_->base);
    QCOMPARE((compare[0][1].value<std::array<QString, 2>>())[0], QString("GGX"));
  }

  /// One number for one thing: the ranking's SNR is that of the comparison.
  void theComparisonTellsTheSameSnr() {
    const auto reference = comparisonReference(widgets::measuredSubject(material_->base, material_->density));
    const SheetSource source = sheetSource("acrylic", material_, ranking_);
    for (const SheetEntry& entry : source.entries)
      QCOMPARE(compareSubjects(entry.subject({}), *reference).renderedSnr, entry.snr);
  }

  /// A window that is closed while it works leaves no work behind.
  void closingEndsTheWork() {
    BackgroundTasks tasks;
    { ContactSheetWindow window(tasks, sheetSource("acrylic", material_, ranking_), nullptr); }
    QVERIFY(tasks.isIdle());
  }

  void tableAsCsv() {
    const QStringList lines = ranking_.csv().trimmed().split('\n');
    QCOMPARE(lines.size(), qsizetype(4));
    for (const QString& line : lines) QCOMPARE(line.count(','), lines[0].count(','));
    QVERIFY(lines[0].startsWith("model,rendered SNR [dB]"));
  }

 private:
  LoadedMaterialPtr material_;
  FitRankingModel ranking_;
};

GONIO_TEST(ContactSheetTest)

}  // namespace contact_sheet_test

#include "contact_sheet_test.moc"
