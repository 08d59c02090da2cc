// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/document.h"

namespace gonio::app {

/// Changes one parameter of the edit. Steps of one interaction (a drag of a slider) merge into one; a drag that ends
/// where it began leaves no step.
class ChangeParameterCommand final : public Command {
 public:
  ChangeParameterCommand(Document& document, int parameter, const Rgb& value, int interaction, bool reset = false);

  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override;
  std::size_t bytes() const override { return sizeof(*this); }

 protected:
  void apply() override { m_document.setEditedValue(m_parameter, m_after); }
  void revert() override { m_document.setEditedValue(m_parameter, m_before); }
  void release() override {}

 private:
  void describe();

  Document& m_document;
  int m_parameter, m_interaction;
  bool m_reset;
  Rgb m_before, m_after;
};

/// Changes the edit of factors. Steps of one interaction (a drag of a curve) merge into one; a drag that ends where it
/// began leaves no step.
class ChangeFactorsCommand final : public Command {
 public:
  using Factors = std::optional<editing::FactorEdit>;
  ChangeFactorsCommand(Document& document, const Factors& after, int interaction, const QString& text);

  int id() const override { return 2; }
  bool mergeWith(const QUndoCommand* other) override;
  std::size_t bytes() const override;

 protected:
  void apply() override { m_document.replaceFactors(m_after); }
  void revert() override { m_document.replaceFactors(m_before); }
  void release() override { m_before = m_after = {}; }

 private:
  Document& m_document;
  int m_interaction;
  Factors m_before, m_after;
};

/// Changes how much of the model's edit counts, and whether it does. Steps of one interaction merge into one.
class ChangeEditShareCommand final : public Command {
 public:
  ChangeEditShareCommand(Document& document, double strength, bool enabled, int interaction, const QString& text);

  int id() const override { return 3; }
  bool mergeWith(const QUndoCommand* other) override;
  std::size_t bytes() const override { return sizeof(*this); }

 protected:
  void apply() override { m_document.setEditShare(m_after.strength, m_after.enabled); }
  void revert() override { m_document.setEditShare(m_before.strength, m_before.enabled); }
  void release() override {}

 private:
  struct Share {
    double strength;
    bool enabled;
    bool operator==(const Share&) const = default;
  };

  Document& m_document;
  int m_interaction;
  Share m_before, m_after;
};

/// Replaces the whole edit state: choosing a fit, resetting everything, pasting.
class ReplaceStateCommand final : public Command {
 public:
  ReplaceStateCommand(Document& document, EditState after, const QString& text);

  std::size_t bytes() const override;

 protected:
  void apply() override { m_document.setState(m_after); }
  void revert() override { m_document.setState(m_before); }
  void release() override;

 private:
  Document& m_document;
  EditState m_before, m_after;
};

/// Puts another material in the place of the document's. What stands beside the material (edits, the automatic fit, the
/// file) goes and comes back with it.
class ReplaceMaterialCommand final : public Command {
 public:
  ReplaceMaterialCommand(Document& document, LoadedMaterialPtr after, const QString& text);

  std::size_t bytes() const override;

 protected:
  void apply() override;
  void revert() override;
  void release() override;

 private:
  struct Content {
    LoadedMaterialPtr material;
    EditState state;
    QString path;
  };
  Content current() const;
  void show(const Content& content);

  Document& m_document;
  Content m_before, m_after;
};

}  // namespace gonio::app
