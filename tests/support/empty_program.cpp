// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Precompiled headers belong to a program; this one belongs to them.
int main() { return 0; }
