// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_sheet.h"

#include <QImage>
#include <QPalette>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "app/gonio/comparison/comparison_numbers.h"
#include "core/models/registry.h"
#include "core/study/accuracy_study.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"

namespace study_sheet_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

bool wait(const std::function<bool()>& done) { return QTest::qWaitFor(done, patienceMilliseconds); }

/// With fewer samples than for people.
struct Sheet : StudySheet {
  explicit Sheet(BackgroundTasks& tasks) : StudySheet(tasks) { pictures().setSamples(16); }
};

class StudySheetTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    material_ = glossyMaterial(0.3, HalfDifferenceGrid{20, 20, 20});
    study::StudyOptions options;
    options.timed = false;
    source_ = {.name = "acrylic", .material = material_, .entries = {}};
    options.measured = [this](const study::MeasuredRepresentation& one) {
      source_.entries.push_back(std::make_shared<const study::MeasuredRepresentation>(one));
    };
    study::runStudy({material_->table(), material_->material.brdf},
                    study::representationsOf({.names = {"lambert", "ggx", "blinn-phong"}}), options);
    std::ranges::sort(source_.entries, std::greater(), [](const auto& one) { return one->record.renderedSnr; });
    QCOMPARE(source_.entries.size(), std::size_t(3));
  }

  /// The note in place of an image that is not rendered yet can be read in the dark theme.
  void placeholdersHaveTheColourOfTexts() {
    widgets::ContactSheet sheet;
    QPalette dark;
    dark.setColor(QPalette::Text, Qt::white);
    for (const auto role : {QPalette::Window, QPalette::Base}) dark.setColor(role, Qt::black);
    sheet.setPalette(dark);
    sheet.resize(300, 300);
    sheet.setTiles({{.name = {}, .numbers = {}, .picture = {}, .map = {}}});
    const QImage image = sheet.grab().toImage();
    int brightest = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) brightest = std::max(brightest, qGray(image.pixel(x, y)));
    QVERIFY(brightest > 120);
  }

  /// The material first, then the entries in their order; pictures and maps of all on one scale; fewer where fewer are
  /// asked for.
  void showsTheEntriesInOrder() {
    BackgroundTasks tasks;
    Sheet window(tasks);
    window.setSources({source_});
    window.pictures().setRendering(true);
    QVERIFY(wait([&] { return window.pictures().isComplete(); }));
    const auto& tiles = window.sheet().tiles();
    QCOMPARE(tiles.size(), std::size_t(4));
    QVERIFY(tiles[0].map.isNull() && !tiles[0].picture.isNull());
    QCOMPARE(tiles[1].name, QString("GGX"));
    for (std::size_t i = 1; i < tiles.size(); ++i) {
      QVERIFY(!tiles[i].picture.isNull() && tiles[i].map.size() == tiles[i].picture.size());
      QVERIFY(tiles[i].numbers.contains(" dB"));
    }
    window.setCount(2);
    QVERIFY(wait([&] { return window.pictures().isComplete() && window.sheet().tiles().size() == 3; }));
    const QImage narrow = window.sheet().picture(64, 1), wide = window.sheet().picture(64, 3);
    QVERIFY(narrow.height() > 2 * wide.height() && wide.width() > 2 * narrow.width());
  }

  /// Long names and a long colour scale stay in their places: no text runs into the gaps between tiles or off the
  /// sheet.
  void textsFit() {
    widgets::ContactSheet sheet;
    QPixmap grey(8, 8);
    grey.fill(Qt::gray);
    const QString name = QString("a very long name of a material ").repeated(8);
    sheet.setTiles({{name, name, grey, grey}, {name, name, grey, grey}});
    sheet.setRange(0.0123);
    for (const int columns : {1, 2}) {
      constexpr int side = 112;
      const QImage picture = sheet.picture(side, columns);
      const int gap = (picture.width() - columns * side) / (columns + 1);
      const auto isWhite = [&](int left, int right) {
        for (int y = 0; y < picture.height(); ++y)
          for (int x = left; x < right; ++x)
            if (picture.pixelColor(x, y) != QColor(Qt::white)) return false;
        return true;
      };
      QVERIFY(isWhite(0, gap));
      QVERIFY(isWhite(picture.width() - gap, picture.width()));
      // The texts of a tile end before the next row.
      const auto rowIsWhite = [&](int y) {
        for (int x = 0; x < picture.width(); ++x)
          if (picture.pixelColor(x, y) != QColor(Qt::white)) return false;
        return true;
      };
      QVERIFY(rowIsWhite(picture.height() - 1));
      QVERIFY(rowIsWhite(0));
    }
    // The end of a name, which distinguishes it, is shown.
    const auto drawn = [&](const QString& end) {
      sheet.setTiles({{name + end, {}, grey, grey}});
      return sheet.picture(112, 1);
    };
    QVERIFY(drawn("rougher") != drawn("smoother"));
    const QByteArray pdf = sheet.pdf(112, 2);
    QVERIFY(pdf.startsWith("%PDF-") && pdf.contains("/Count 1"));
  }

  /// Only what is shown is rendered, the rest when it is asked for.
  void rendersWhatIsShown() {
    BackgroundTasks tasks;
    Sheet window(tasks);
    window.setSources({source_});
    window.pictures().setRendering(true);
    window.setCount(1);
    QVERIFY(wait([&] { return window.pictures().isComplete() && tasks.isIdle(); }));
    window.setCount(3);
    QVERIFY(!window.pictures().isComplete() && !tasks.isIdle());
    QVERIFY(window.sheet().tiles()[3].map.isNull());
    QCOMPARE(window.sheet().tiles()[3].picture.width(), study::StudyOptions().picture.width);  // the study's own
    QVERIFY(wait([&] { return window.pictures().isComplete() && tasks.isIdle(); }));
    for (const widgets::SheetTile& tile : window.sheet().tiles()) QVERIFY(!tile.picture.isNull());
  }

  /// Several materials have a row each, with maps on one scale and a note where nothing was measured. A material of the
  /// library is read when its picture is needed.
  void severalMaterialsHaveRows() {
    BackgroundTasks tasks;
    Sheet window(tasks);
    SheetSource other{.name = "gold_paint", .id = "library:sgd/gold-metallic-paint", .entries = source_.entries};
    other.entries[1] = nullptr;
    other.entries[0] = std::make_shared<const study::MeasuredRepresentation>(*other.entries[0]);
    other.entries[2] = std::make_shared<const study::MeasuredRepresentation>(*other.entries[2]);
    window.setSources({source_, other});
    window.pictures().setRendering(true);
    QVERIFY(wait([&] { return window.pictures().isComplete() && tasks.isIdle(); }));
    const auto& tiles = window.sheet().tiles();
    QCOMPARE(tiles.size(), std::size_t(8));
    QCOMPARE(window.sheet().columns(), 4);
    QCOMPARE(tiles[4].name, QString("gold paint"));
    QCOMPARE(tiles[4].numbers, QString("Model fit"));
    QVERIFY(tiles[4].picture.toImage() != tiles[0].picture.toImage());
    QVERIFY(tiles[6].picture.isNull() && tiles[6].note == "Not measured");
    // The map of one material would end at a smaller difference: acrylic against gold is far.
    BackgroundTasks alone;
    Sheet first(alone);
    first.setSources({source_});
    first.pictures().setRendering(true);
    QVERIFY(wait([&] { return first.pictures().isComplete() && alone.isIdle(); }));
    QVERIFY(window.pictures().range() > first.pictures().range());
    // A material of the library and a fit go to the preview, too; what was not measured does not.
    QSignalSpy compare(&window, &StudySheet::compareRequested);
    window.sheet().toggle(4);
    window.sheet().toggle(5);
    window.compareSelected();
    QVERIFY(wait([&] { return compare.count() == 1; }));
    const auto names = compare[0][1].value<std::array<QString, 2>>();
    QVERIFY(names[0] == "gold paint" && names[1] == "GGX");
    // Columns are kept in the widget, however narrow it is.
    QVERIFY(window.sheet().heightForWidth(400) < window.sheet().heightForWidth(1000));
  }

  /// Two tiles go to the preview: the material in its native form and the model alone.
  void comparesTwo() {
    BackgroundTasks tasks;
    Sheet window(tasks);
    window.setSources({source_});
    window.pictures().setRendering(true);
    QSignalSpy compare(&window, &StudySheet::compareRequested);
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
    for (std::size_t i = 0; i < source_.entries.size(); ++i)
      QCOMPARE(compareSubjects(StudySheet::subjectOf(source_, int(i), {}), *reference).renderedSnr,
               source_.entries[i]->record.renderedSnr);
  }

  /// A window that is closed while it works leaves no work behind.
  void closingEndsTheWork() {
    BackgroundTasks tasks;
    {
      Sheet window(tasks);
      window.setSources({source_});
      window.pictures().setRendering(true);
      QVERIFY(!tasks.isIdle());
    }
    QVERIFY(tasks.isIdle());
  }

  /// Another order needs no new pictures; results that are measured anew do.
  void picturesStay() {
    BackgroundTasks tasks;
    Sheet window(tasks);
    window.setSources({source_});
    window.pictures().setRendering(true);
    QVERIFY(wait([&] { return window.pictures().isComplete() && tasks.isIdle(); }));
    SheetSource reversed = source_;
    std::ranges::reverse(reversed.entries);
    window.setSources({reversed});
    QVERIFY(window.pictures().isComplete() && tasks.isIdle());
    QVERIFY(window.sheet().tiles()[3].name == "GGX" && !window.sheet().tiles()[3].map.isNull());
    reversed.entries[0] = std::make_shared<const study::MeasuredRepresentation>(*reversed.entries[0]);
    window.pictures().setRendering(false);
    window.setSources({reversed});
    QVERIFY(!window.pictures().isComplete() && tasks.isIdle() && window.sheet().tiles()[1].map.isNull());
    window.pictures().setRendering(true);
    QVERIFY(wait([&] { return window.pictures().isComplete(); }));
    window.setSources({});
    QVERIFY(window.sheet().tiles().empty());
  }

 private:
  LoadedMaterialPtr material_;
  SheetSource source_;
};

GONIO_TEST(StudySheetTest)

}  // namespace study_sheet_test

#include "study_sheet_test.moc"
