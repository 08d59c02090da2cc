// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTest>
#include <QToolButton>

#include "app/gonio/factors/factor_curves_panel.h"
#include "app/gonio/factors/factor_terms_view.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/widgets/child.h"
#include "widgets/curves/curve_editor.h"

namespace gonio::app::test_support {

/// The dock's panel on one material.
class OpenFactorCurves {
 protected:
  BackgroundTasks m_tasks;
  Document m_document;
  std::unique_ptr<FactorCurvesPanel> m_panel;

  const editing::FactorEdit& edit() const { return *factorEdit(m_document); }
  widgets::CurveEditor& editor(FactorAxis axis) const { return m_panel->column(axis).editor(); }
  FactorTermsView& termsView() const { return *m_panel->findChild<FactorTermsView*>(); }
  template <class Widget>
  Widget* child(const QString& name) const {
    return test::child<Widget>(*m_panel, name);
  }
  void press(FactorAxis axis, const QString& text) const {
    for (QToolButton* button : m_panel->column(axis).findChildren<QToolButton*>())
      if (button->text() == text) return button->click();
    QFAIL(qPrintable("no button " + text));
  }

  void openPanel() {
    m_panel = std::make_unique<FactorCurvesPanel>(m_document, m_tasks);
    m_panel->resize(1200, 400);
    m_document.setMaterial(glossyMaterial(0.3, {24, 24, 24}));
    QVERIFY(editor(FactorAxis::theta).nodes().empty());
    m_panel->show();
    QVERIFY(!m_panel->isSettled());
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds);
  }

  void undoAll() {
    m_document.history().setIndex(0);
    m_document.history().clear();
    termsView().setTerms(3);
    QVERIFY(!factorEdit(m_document));
  }
};

}  // namespace gonio::app::test_support
