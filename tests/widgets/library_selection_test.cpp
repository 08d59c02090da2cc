// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_selection.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/widgets/library_test_support.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/library/library_chips.h"
#include "widgets/library/quick_look.h"

namespace library_selection_test {
using namespace gonio::widgets;
using namespace gonio::test;

class LibrarySelectionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The keys and signals of a selection of several, in the order in which they are shown.
  void severalAreSelected() {
    LibraryModel model;
    LibraryView view(&model);
    view.resize(400, 400);
    view.show();
    model.setItems(threeMaterials());
    QSignalSpy interpolate(&view.selection(), &LibrarySelection::interpolationRequested),
        open(&view.selection(), &LibrarySelection::openRequested);
    QTest::keyClick(view.list(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(view.selection().ids(), QStringList({"b", "c", "a"}));
    QTest::keyClick(view.list(), Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(interpolate[0][0].toStringList(), QStringList({"b", "c", "a"}));
    const QSignalSpy changed(&model, &LibraryModel::notesChanged);
    QTest::keyClick(view.list(), Qt::Key_Asterisk);
    for (const char* id : {"a", "b", "c"}) QVERIFY(model.note(id).favourite);
    QCOMPARE(changed.count(), 1);
    QTest::keyClick(view.list(), Qt::Key_Asterisk);
    for (const char* id : {"a", "b", "c"}) QVERIFY(model.note(id).isEmpty());
    QVERIFY(open.isEmpty());
    view.selection().setSingle();
    view.selection().select("c");
    QCOMPARE(view.selection().ids(), QStringList{"c"});
    QTest::keyClick(view.list(), Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(interpolate.count(), 1);
  }

  /// What a menu offers depends on how many are selected.
  void theMenuFitsTheSelection() {
    QStringList asked;
    LibraryActions actions{.open = [&](const QString& id) { asked << "open " + id; },
                           .comparePair = [&](const QStringList& two) { asked << "pair " + two.join(' '); },
                           .study = [&](const QStringList& all) { asked << "study " + all.join(' '); },
                           .exportAll = [&](const QStringList& all) { asked << "export " + all.join(' '); },
                           .favour = [](const QStringList&, bool) {}};
    const auto texts = [&](const QStringList& ids) {
      const std::unique_ptr<QMenu> menu(libraryMenu(ids, {}, actions, nullptr));
      QStringList result;
      for (QAction* action : menu->actions()) {
        action->trigger();
        if (!action->isSeparator()) result << action->text().remove('&');
      }
      return result;
    };
    QCOMPARE(texts({"a"}), QStringList({"Open", "Export...", "Favourite"}));
    QCOMPARE(texts({"a", "b"}), QStringList({"Compare These 2", "Measure Representations of These 2...",
                                             "Export These 2...", "Favourites"}));
    QCOMPARE(texts({"a", "b", "c"}),
             QStringList({"Measure Representations of These 3...", "Export These 3...", "Favourites"}));
    QCOMPARE(asked,
             QStringList({"open a", "export a", "pair a b", "study a b", "export a b", "study a b c", "export a b c"}));
  }

  /// Space shows a large picture, which follows the selection and goes with Escape.
  void quickLook() {
    LibraryModel model;
    LibraryView view(&model);
    view.show();
    model.setItems(threeMaterials());
    QSignalSpy wanted(&view.selection(), &LibrarySelection::largePictureRequested);
    const QuickLook& look = view.selection().quickLook();
    view.selection().select("b");
    QTest::keyClick(view.list(), Qt::Key_Space);
    QVERIFY(look.isVisible());
    QCOMPARE(look.id(), QString("b"));
    QTest::keyClick(view.list(), Qt::Key_Right);
    QCOMPARE(look.id(), QString("c"));
    QCOMPARE(wanted.count(), 2);
    QTest::keyClick(view.list(), Qt::Key_Escape);
    QVERIFY(!look.isVisible());
    QTest::keyClick(view.list(), Qt::Key_Left);
    QCOMPARE(wanted.count(), 2);
  }

  void favouritesByKeyboard() {
    LibraryModel model;
    LibraryView view(&model);
    model.setItems(threeMaterials());
    QSignalSpy changed(&model, &LibraryModel::notesChanged);
    view.selection().select("b");
    QTest::keyClick(view.list(), Qt::Key_Asterisk);
    QCOMPARE(changed[0][0].value<LibraryNotes>().keys(), QStringList{"b"});
    QVERIFY(model.note("b").favourite);
    view.setChipsShown(true);
    view.chips().chip("Favourites")->setChecked(true);
    QCOMPARE(idsOf(view), QStringList{"b"});
    QTest::keyClick(view.list(), Qt::Key_Asterisk);
    QCOMPARE(changed.count(), 2);
    QVERIFY(idsOf(view).isEmpty());
  }

  /// What is selected stays so when the materials are listed again; what is not listed yet is selected when it comes.
  void selectionOutlivesANewList() {
    LibraryModel model;
    LibraryView view(&model);
    model.setItems(threeMaterials());
    const auto selected = [&] { return view.selection().ids(); };
    view.selection().select("b");
    model.setItems(threeMaterials());
    QCOMPARE(selected(), QStringList{"b"});
    QCOMPARE(view.list()->currentIndex().data(LibraryModel::IdRole).toString(), QString("b"));

    view.selection().select("new");
    QVERIFY(selected().isEmpty());
    std::vector<LibraryItem> more = threeMaterials();
    more.push_back({.id = "new", .name = "new"});
    model.setItems(more);
    QCOMPARE(selected(), QStringList{"new"});

    view.list()->selectAll();
    const auto sorted = [](QStringList ids) {
      ids.sort();
      return ids;
    };
    const QStringList all = sorted(selected());
    model.setItems(more);
    QCOMPARE(sorted(selected()), all);
    QCOMPARE(all.size(), 4);
    view.list()->clearSelection();
    model.setItems(threeMaterials());
    QVERIFY(selected().isEmpty());
  }

  /// The keys 0 to 5 rate what is selected; the order by rating, the menu and the tool tip follow.
  void ratings() {
    LibraryModel model;
    LibraryView view(&model);
    model.setItems(threeMaterials());
    view.selection().select("a");
    QTest::keyClick(view.list(), Qt::Key_5);
    view.selection().select("c");
    QTest::keyClick(view.list(), Qt::Key_2);
    QCOMPARE(model.note("a").rating, 5);
    view.setSortMode(5);
    QCOMPARE(idsOf(view), QStringList({"a", "c", "b"}));
    QVERIFY(model.index(0).data(richToolTipRole).toString().contains("Rating"));
    QTest::keyClick(view.list(), Qt::Key_0);
    QCOMPARE(model.note("c").rating, 0);
    QStringList asked;
    LibraryActions actions{
        .rate = [&](const QStringList& ids, int rating) { asked << ids.join(' ') + QString::number(rating); }};
    const std::unique_ptr<QMenu> menu(libraryMenu({"a", "b"}, {.rating = 3}, actions, nullptr));
    for (QAction* action : menu->findChild<QMenu*>()->actions()) {
      QCOMPARE(action->isChecked(), asked.size() == 3);
      action->trigger();
    }
    QCOMPARE(asked, QStringList({"a b0", "a b1", "a b2", "a b3", "a b4", "a b5"}));
  }
};

GONIO_TEST(LibrarySelectionTest)
}  // namespace library_selection_test

#include "library_selection_test.moc"
