// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_view.h"

#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/support/test_program.h"
#include "tests/widgets/library_test_support.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/library/library_chips.h"
#include "widgets/library/library_model.h"
#include "widgets/library/library_selection.h"

namespace library_view_test {
using namespace gonio::widgets;
using namespace gonio::test;

class LibraryViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void picturesComeLater() {
    LibraryModel model;
    model.setItems(threeMaterials());
    QCOMPARE(model.pending(), QStringList({"a", "b", "c"}));
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    model.setThumbnail("b", makeThumbnail(10, 0.1));
    model.setFailure("c", "c.bsdf: too short", "cannot be read");
    model.setThumbnail("gone", makeThumbnail(0, 0));
    QCOMPARE(changed.count(), 2);
    QCOMPARE(model.pending(), QStringList{"a"});
    QVERIFY(!model.index(1).data(Qt::DecorationRole).isNull());
    QVERIFY(model.index(2).data(richToolTipRole).toString().contains("too short"));
    QCOMPARE(model.index(2).data(LibraryModel::FailureBadgeRole).toString(), QString("cannot be read"));
  }

  /// The columns share the width of the view, and no row of tiles loses a column to the rounding.
  void tilesFillTheWidth() {
    LibraryModel model;
    LibraryView view(&model);
    view.show();
    view.setTileSize(64);
    std::vector<LibraryItem> items;
    for (int i = 0; i < 40; ++i) items.push_back({QString::number(i), i < 33 ? "gold" : "tin", "MERL file"});
    model.setItems(items);
    for (const int width : {200, 257, 333, 410}) {
      view.resize(width, 300);
      const QListView& list = *view.list();
      const auto rectOf = [&](int row) { return list.visualRect(list.model()->index(row, 0)); };
      const auto columns = [&] {
        int count = 1;
        while (count < list.model()->rowCount() && rectOf(count).top() == rectOf(0).top()) ++count;
        return count;
      };
      const int margins = 2 * 4;
      const int room = list.maximumViewportSize().width() - list.verticalScrollBar()->sizeHint().width();
      const int expected = (room - list.spacing() - 1) / (64 + margins + list.spacing());
      QTRY_COMPARE(columns(), expected);
      const int lost = room - rectOf(expected - 1).right() - list.spacing();
      QVERIFY(lost >= 0 && lost <= expected + 1);
      // Where a search leaves a few, which need no scroll bar, too.
      view.search()->setText("tin");
      QTRY_COMPARE(list.model()->rowCount(), 7);
      QTRY_COMPARE(columns(), expected);
      view.search()->clear();
    }
  }

  /// Long names stay distinguishable: their ends are shown, on two lines at most.
  void endsOfLongNamesAreShown() {
    LibraryModel model;
    LibraryView view(&model);
    view.resize(400, 300);
    view.setTileSize(64);
    view.show();
    model.setItems({{"a", "color-changing-paint1", ""}, {"b", "color-changing-paint2", ""}});
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QListView& list = *view.list();
    const QImage shown = list.viewport()->grab().toImage();
    const auto tile = [&](int row) { return list.visualRect(list.model()->index(row, 0)); };
    QTRY_VERIFY(tile(1).left() > tile(0).right());
    QCOMPARE(tile(0).size(), tile(1).size());
    const int picture = 64 + 4;
    const auto name = [&](int row) { return shown.copy(tile(row).adjusted(4, picture, -4, 0)); };
    QVERIFY(name(0) != name(1));
  }

  void searchSortAndOpenByKeyboard() {
    LibraryModel model;
    LibraryView view(&model);
    view.resize(400, 400);
    view.show();
    model.setItems(threeMaterials());
    QSignalSpy opened(&view.selection(), &LibrarySelection::openRequested);
    QCOMPARE(idsOf(view), QStringList({"b", "c", "a"}));
    model.setThumbnail("a", makeThumbnail(45, 0.2));
    model.setThumbnail("b", makeThumbnail(-1, 0.01));
    model.setThumbnail("c", makeThumbnail(120, 0.9));
    view.setSortMode(1);
    QCOMPARE(idsOf(view), QStringList({"b", "a", "c"}));
    view.setSortMode(2);
    QCOMPARE(idsOf(view), QStringList({"b", "a", "c"}));
    QTest::keyClicks(view.search(), "fel");
    QCOMPARE(idsOf(view), QStringList{"c"});
    QTest::keyClick(view.search(), Qt::Key_Return);
    QCOMPARE(opened.count(), 1);
    QCOMPARE(opened[0][0].toString(), QStringLiteral("c"));
    view.search()->clear();
    view.selection().select("a");
    QTest::keyClick(view.list(), Qt::Key_Return);
    QCOMPARE(opened[1][0].toString(), QStringLiteral("a"));
  }

  /// Words in any order, each the beginning of a word of the name, the kind, the badge or the source.
  void searchByWords() {
    LibraryModel model;
    LibraryView view(&model);
    model.setItems({{"a", "grease-covered-steel", "", "near-measured", "MERL", "Metal"},
                    {"b", "red-metallic-paint", "", "near-measured", "MERL", "Paint"},
                    {"c", "blue_metallic paint2", "", "measured", "RGL", "Paint"},
                    {"d", "Red Fabric", "", "published fit", "SGD", "Fabric"}});
    const std::pair<const char*, QStringList> searches[] = {{"red", {"d", "b"}},
                                                            {"paint red metal", {"b"}},
                                                            {"metallic-paint", {"c", "b"}},
                                                            {"measured rgl", {"c"}},
                                                            {"measured", {"c"}},
                                                            {"near-measured paint", {"b"}},
                                                            {"fabric published", {"d"}},
                                                            {"near metal", {"a", "b"}},
                                                            {"METAL", {"c", "a", "b"}},
                                                            {"overed", {}},
                                                            {"  ", {"c", "a", "d", "b"}},
                                                            {"red blue", {}}};
    for (const auto& [text, ids] : searches) {
      view.search()->setText(text);
      QCOMPARE(idsOf(view), ids);
    }
  }

  /// A material in several qualities is one entry, in its best quality that matches the search and the filter; the menu
  /// opens the others.
  void oneEntryForAllQualities() {
    LibraryModel model;
    LibraryView view(&model);
    const auto item = [](const char* id, const char* name, const char* badge, const char* material) {
      return LibraryItem{.id = id, .name = name, .toolTip = {}, .badge = badge, .kind = "Metal", .material = material};
    };
    model.setItems({item("rgl", "steel_1", "measured", "steel"), item("copy", "steel_1", "close copy", "steel"),
                    item("chrome", "chrome", "close copy", "chrome"), item("fit", "steel_1", "model fit", "steel")});
    QCOMPARE(idsOf(view), QStringList({"chrome", "rgl"}));
    QCOMPARE(model.index(0).data().toString(), QStringLiteral("steel 1"));
    view.search()->setText("model fit");
    QCOMPARE(idsOf(view), QStringList{"fit"});
    view.search()->setText("copy");
    QCOMPARE(idsOf(view), QStringList({"chrome", "copy"}));
    view.search()->clear();
    view.setChipsShown(true);
    view.chips().chip("favourites")->setChecked(true);
    QCOMPARE(idsOf(view), QStringList());
    model.setNote("fit", {.favourite = true});
    QCOMPARE(idsOf(view), QStringList{"fit"});
    model.setNote("rgl", {.favourite = true});
    QCOMPARE(idsOf(view), QStringList{"rgl"});
    view.setChipsShown(false);
    // The entry stands for the quality that is open.
    view.selection().select("fit");
    QCOMPARE(view.selection().ids(), QStringList{"rgl"});
    QStringList opened;
    QMenu* menu = libraryMenu({"rgl"}, {},
                              {.open = [&](const QString& id) { opened << id; },
                               .qualities = {{"rgl", "measured"}, {"copy", "close copy"}, {"fit", "model fit"}}},
                              &view);
    const auto* qualities = menu->findChild<QMenu*>();
    QCOMPARE(qualities->actions().size(), 3);
    qualities->actions()[2]->trigger();
    QCOMPARE(opened, QStringList{"fit"});
    QCOMPARE(model.qualitiesOf("chrome"), QStringList{"chrome"});
  }

  /// By what a material looks like, which is known once it has a thumbnail.
  void searchByLook() {
    LibraryModel model;
    LibraryView view(&model);
    model.setItems({{"a", "chrome", "", "", "", "Metal"},
                    {"b", "cherry", "", "", "", "Paint"},
                    {"c", "felt", "", "", "", "Fabric"}});
    const auto set = [&](const char* id, const QColor& colour, double hue, double roughness) {
      LibraryThumbnail made = makeThumbnail(hue, roughness);
      made.image.fill(colour);
      model.setThumbnail(id, made);
    };
    view.search()->setText("shiny red");
    QCOMPARE(idsOf(view), QStringList());
    set("a", QColor(160, 160, 160), -1, 0.01);
    set("b", QColor(150, 20, 20), 0, 0.1);
    set("c", QColor(20, 120, 30), 127, 0.6);
    const std::pair<const char*, QStringList> searches[] = {{"shiny red", {"b"}},  {"mirror", {"a"}},
                                                            {"carpaint", {"b"}},   {"matt green", {"c"}},
                                                            {"shiny", {"b", "a"}}, {"grey", {"a"}}};
    for (const auto& [text, ids] : searches) {
      view.search()->setText("");
      view.search()->setText(text);
      QCOMPARE(idsOf(view), ids);
    }
  }

  /// By the mean colour of the thumbnail and the roughness; lightness from light to dark.
  void orderByLightnessAndSimilarity() {
    LibraryModel model;
    LibraryView view(&model);
    model.setItems(threeMaterials());
    const auto coloured = [](const QColor& colour, double roughness) {
      LibraryThumbnail made = makeThumbnail(0, roughness);
      made.image.fill(colour);
      return made;
    };
    model.setThumbnail("a", coloured(QColor(200, 30, 30), 0.1));
    model.setThumbnail("b", coloured(QColor(210, 200, 200), 0.1));
    model.setThumbnail("c", coloured(QColor(30, 10, 10), 0.4));
    view.setSortMode(3);
    QCOMPARE(idsOf(view), QStringList({"b", "a", "c"}));
    view.setSortMode(4);
    model.setReference(coloured(QColor(190, 40, 40), 0.1));
    QCOMPARE(idsOf(view), QStringList({"a", "c", "b"}));
    model.setReference(coloured(QColor(200, 200, 205), 0.12));
    QCOMPARE(idsOf(view).front(), QString("b"));
    // Grey 50 %: L* 76.19 by the sRGB transfer function.
    QImage grey(4, 4, QImage::Format_RGB32);
    grey.fill(QColor(188, 188, 188));
    const gonio::Rgb lab = meanLab(grey);
    QVERIFY(std::abs(lab.x - 76.2) < 0.2 && std::abs(lab.y) < 0.01 && std::abs(lab.z) < 0.01);
    QCOMPARE(dissimilarity(lab, 0.1, lab, 0.2), 10.0);
  }

  /// Of several buttons of one sort any, of two sorts both; turned off, everything is shown again.
  /// As the other controls do.
  void pressedChipsFollowTheTheme() {
    LibraryModel model;
    model.setItems(threeMaterials());
    LibraryView view(&model);
    view.setChipsShown(true);
    view.show();
    QToolButton* chip = view.chips().chip("Favourites");
    chip->setChecked(true);
    const auto shown = [chip](const QPalette& theme, const QString& styleSheet) {
      QApplication::setPalette(theme);
      qApp->setStyleSheet(styleSheet);
      QCoreApplication::processEvents();
      return chip->palette().color(QPalette::Button);
    };
    const QPalette before = QApplication::palette();
    QPalette other = before;
    other.setColor(QPalette::Highlight, QColor(1, 2, 3));
    QCOMPARE(shown(other, "QFrame#a { border: none; }"), QColor(1, 2, 3));
    QCOMPARE(shown(before, "QFrame#b { border: none; }"), before.color(QPalette::Highlight));
    qApp->setStyleSheet({});
  }

  void chipsChooseWhatIsShown() {
    LibraryModel model;
    LibraryView view(&model);
    model.setItems({{"a", "gold", "", "measured", "RGL", "Metal"},
                    {"b", "chrome", "", "near-measured", "MERL", "Metal"},
                    {"c", "felt", "", "measured", "RGL", "Fabric"},
                    {"d", "oak", "", "near-measured", "MERL", "Wood"}});
    view.setChipsShown(true);
    LibraryChips& chips = view.chips();
    chips.chip("Metal")->setChecked(true);
    QCOMPARE(idsOf(view), QStringList({"b", "a"}));
    chips.chip("Fabric")->setChecked(true);
    QCOMPARE(idsOf(view), QStringList({"b", "c", "a"}));
    chips.chip("measured")->setChecked(true);
    QCOMPARE(idsOf(view), QStringList({"c", "a"}));
    view.search()->setText("go");
    QCOMPARE(idsOf(view), QStringList{"a"});
    view.setChipsShown(false);
    view.search()->clear();
    QCOMPARE(idsOf(view).size(), 4);
    // Another library has other buttons, and none of them is pressed.
    model.setItems({{"e", "file", "", "", "", ""}});
    QVERIFY(!chips.chip("Metal") && chips.chip("Favourites"));
    QCOMPARE(idsOf(view), QStringList{"e"});
  }

  /// Tags are searched, have buttons as soon as a material has them, and lose them with the last one.
  void tags() {
    LibraryModel model;
    LibraryView view(&model);
    model.setItems(threeMaterials());
    view.setChipsShown(true);
    QVERIFY(!view.chips().chip("car paint"));
    model.setNote("a", {.tags = tagsOf(" car  paint,client X,, car paint")});
    QCOMPARE(model.note("a").tags, QStringList({"car paint", "client X"}));
    model.setNote("b", {.tags = {"car paint"}});
    view.chips().chip("car paint")->setChecked(true);
    QCOMPARE(idsOf(view), QStringList({"b", "a"}));
    view.search()->setText("clie");
    QCOMPARE(idsOf(view), QStringList{"a"});
    // What is pressed stays so.
    model.setNote("a", {.tags = {"car paint"}});
    QVERIFY(!view.chips().chip("client X") && view.chips().chip("car paint")->isChecked());
    view.search()->clear();
    QCOMPARE(idsOf(view), QStringList({"b", "a"}));
    model.setNote("a", {});
    model.setNote("b", {});
    QVERIFY(!view.chips().chip("car paint"));
    QCOMPARE(idsOf(view).size(), 3);
  }

  void whatWasOpenedLately() {
    LibraryModel model;
    LibraryView view(&model);
    model.setItems(threeMaterials());
    const QDateTime now = QDateTime::currentDateTime();
    model.setNotes({{"a", {.opened = now.addDays(-30)}}, {"c", {.opened = now.addSecs(-60)}}});
    view.setSortMode(6);
    QCOMPARE(idsOf(view), QStringList({"c", "a", "b"}));
    view.setChipsShown(true);
    view.chips().chip("Recent")->setChecked(true);
    QCOMPARE(idsOf(view), QStringList{"c"});
  }

  /// Another list of the same files keeps the thumbnails, except of files that have changed.
  void thumbnailsStay() {
    LibraryModel model;
    model.setItems({{.id = "a", .version = 1}, {.id = "b", .version = 1}});
    for (const char* id : {"a", "b"}) model.setThumbnail(id, {QImage(4, 4, QImage::Format_RGB32), 0, 0.5});
    model.setItems({{.id = "c"}, {.id = "b", .version = 2}, {.id = "a", .version = 1}});
    QCOMPARE(model.pending(), QStringList({"c", "b"}));
  }

  /// Groups in the order of their first materials (by source) or of the alphabet (by kind), each below its heading.
  void groupsStandBelowHeadings() {
    LibraryModel model;
    LibraryView view(&model);
    view.resize(400, 400);
    view.show();
    model.setItems({{"a", "gold", "", "measured", "RGL", "Metal"},
                    {"b", "chrome", "", "copy", "MERL", "Metal"},
                    {"c", "felt", "", "measured", "RGL", "Fabric"}});
    const auto rows = [&] {
      QStringList result;
      for (int row = 0; row < view.list()->model()->rowCount(); ++row) {
        const QModelIndex index = view.list()->model()->index(row, 0);
        result << (index.data(LibraryModel::HeadingRole).toBool() ? "# " : "") + index.data().toString();
      }
      return result;
    };
    QCOMPARE(rows(), QStringList({"chrome", "felt", "gold"}));
    view.setGrouping(int(LibraryGrouping::source));
    QCOMPARE(rows(), QStringList({"# RGL", "felt", "gold", "# MERL", "chrome"}));
    view.setGrouping(int(LibraryGrouping::kind));
    QCOMPARE(rows(), QStringList({"# Fabric", "felt", "# Metal", "chrome", "gold"}));
    const auto current = [&] { return view.list()->currentIndex().data().toString(); };
    QTest::keyClick(view.list(), Qt::Key_End);
    QCOMPARE(current(), QStringLiteral("gold"));
    QTest::keyClick(view.list(), Qt::Key_Home);
    QCOMPARE(current(), QStringLiteral("felt"));
    view.search()->setText("metal");  // a kind; the heading of what does not match goes
    QCOMPARE(rows(), QStringList({"# Metal", "chrome", "gold"}));
    QSignalSpy opened(&view.selection(), &LibrarySelection::openRequested);
    QTest::keyClick(view.search(), Qt::Key_Return);
    QCOMPARE(opened.count(), 1);
    QCOMPARE(opened[0][0].toString(), QStringLiteral("b"));  // the first material, not the heading
    QVERIFY(!view.visibleIds().contains(QString()));
    QCOMPARE(model.pending(), QStringList({"a", "b", "c"}));
  }

  void tellsWhatIsInSight() {
    LibraryModel model;
    LibraryView view(&model);
    view.resize(250, 300);
    view.show();
    std::vector<LibraryItem> many;
    for (int i = 0; i < 200; ++i) many.push_back({QString::number(i), QString::number(i), {}});
    QSignalSpy visible(&view, &LibraryView::visibleIdsChanged);
    model.setItems(many);
    QTRY_VERIFY(visible.count() > 0);
    const qsizetype count = visible.last()[0].toStringList().size();
    QVERIFY(count > 0 && count < 50);
  }
};

GONIO_TEST(LibraryViewTest)
}  // namespace library_view_test

#include "library_view_test.moc"
