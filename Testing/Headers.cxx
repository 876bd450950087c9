// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Nothing: a target must have a source to have the headers precompiled that the tests share.
