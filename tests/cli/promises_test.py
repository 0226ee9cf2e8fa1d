#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What all commands promise: exit statuses, files, streams, what an empty complex is called.

Usage: promises_test.py PROGRAM [unittest options]
"""

import csv
import io
import json
import os
import pathlib
import pty
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree

from program import C60, EIGHT, InAFolder, MALFORMED, PROGRAM, ROOT, SAMPLES, TWO_BALLS, orthoball

TORI = SAMPLES / "linked_tori.csv"
# What commands are given beside INPUT, if they read another file.
BESIDE = {"locate": [C60], "enforce": [ROOT / "tests" / "cli" / "edge.txt"]}
COMMANDS = ["summary", "signatures", "filter", "measure", "pockets", "alpha", "persistence", "locate",
            "enforce"]  # that write to standard output


class ExitStatuses(InAFolder):
    def test_wrong_usage_is_2(self):
        for arguments in [
            [],
            ["no_such_command"],
            ["summary", C60, "--threads", "0"],
            ["summary", C60, "--threads", "2000"],
            ["summary", C60, "--threads", "some"],
            ["summary", C60, "--memory-limit", "-1"],
            ["summary", C60, "--memory-limit", "1e9"],
            ["summary", C60, "--memory-limit", "99999999T"],
            ["summary", C60, "--memory-limit", "many"],
            ["summary"],
            ["summary", C60, "--no-such-option"],
            ["summary", C60, "--dimension", "4"],
            ["signatures", C60, "--alpha2", "1", "--alpha", "1"],
            ["signatures", C60, "--alpha2", "one"],
            ["signatures", C60, "--alpha2", "inf"],
            ["signatures", C60, "--alpha", "1e400"],
            ["signatures", C60, "--alpha", "1e200"],
            ["signatures", C60, "--inverse-alpha", "0"],
            ["signatures", C60, "--index", "100000"],
            ["signatures", C60, "--index", "-1"],
            ["signatures", C60, "--samples", "0"],
            ["signatures", C60, "--plot-range", "2,1", "--plot", self.folder / "x.svg"],
            ["filter", C60, "--alpha2", "1,2"],
            ["shape", C60],
            ["shape", C60, "-o", self.folder / "surface"],
            ["shape", C60, "-o", self.folder / "surface.geojson"],
            ["shape", EIGHT, "-o", self.folder / "surface.stl"],
            ["filter", C60, "--format", "xml"],
            ["summary", "-"],
            ["alpha"],
            ["alpha", C60, "--resamples", "-1"],
            ["alpha", C60, "--seed", "one"],
            ["alpha", C60, "--alpha2", "1"],
            ["alpha", C60, "--format", "xml"],
            ["persistence"],
            ["persistence", C60, "--homology-dimension", "3"],
            ["persistence", EIGHT, "--homology-dimension", "2"],
            ["persistence", C60, "--minimum-length", "-1"],
            ["persistence", C60, "--plot-kind", "barcode"],
            ["persistence", C60, "--format", "ply"],
            ["persistence", C60, "--representatives", self.folder / "classes.csv"],
            ["locate", C60],
            ["locate", C60, C60, "--alpha2", "1,2"],
            ["locate", C60, C60, "--region", "0"],
            ["locate", C60, C60, "--query-format", "xml"],
            ["enforce", C60],
            ["enforce", C60, *BESIDE["enforce"], "--alpha2", "1,2"],
            ["enforce", C60, *BESIDE["enforce"], "--index", "100000"],
        ]:
            with self.subTest(arguments=arguments):
                self.refused(2, *arguments)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_empty_value_is_not_the_same_as_none(self):
        commands = ["shape", *COMMANDS]
        alphas = [command for command in commands if command not in ["alpha", "persistence"]]
        tables = [command for command in commands if command != "enforce"]
        edits = ["shape", "locate"]
        options = {"--alpha2": alphas, "--alpha": alphas, "--inverse-alpha": alphas,
                   "--index": alphas, "--columns": commands, "--radius-column": commands,
                   "--weight-column": commands, "--radii": commands, "--default-radius": commands,
                   "--model": commands, "--altloc": commands, "--chain": commands,
                   "--waters": commands, "--input-format": commands, "--dimension": commands,
                   "--threads": commands, "--memory-limit": commands, "--progress": commands,
                   "--output": commands, "--format": tables, "--samples": ["signatures"],
                   "--plot": ["signatures", "persistence"],
                   "--plot-axis": ["signatures", "persistence"], "--plot-kind": ["persistence"],
                   "--homology-dimension": ["persistence"], "--minimum-length": ["persistence"],
                   "--representatives": ["persistence"],
                   "--representatives-alpha2": ["persistence"], "--resamples": ["alpha"],
                   "--seed": ["alpha"], "--query-format": ["locate"], "--query-columns": ["locate"],
                   "--hole-threshold": edits, "--region-threshold": edits, "--region": edits,
                   "--changes": ["shape"], "--weights": commands,
                   "--plot-range": ["signatures"], "--probe": ["measure", "pockets"],
                   "--per-atom": ["measure"], "--per-residue": ["measure"], "--voids": ["measure"],
                   "--contacts": ["measure"], "--derivatives": ["measure"],
                   "--pdb": ["measure"], "--mesh": ["measure", "pockets"],
                   "--script": ["measure", "pockets"], "--cells": ["measure"],
                   "--cells-within": ["measure"], "--cells-box": ["measure"],
                   "--cells-tolerance": ["measure"]}
        for option, where in options.items():
            for command in where:
                with self.subTest(option=option, command=command):
                    self.assertIn(f"{option}: the value is empty",
                                  self.refused(2, command, C60, *BESIDE.get(command, []), option,
                                               ""))
        self.assertIn("INPUT: the value is empty", self.refused(2, "summary", ""))
        self.assertIn("QUERY: the value is empty", self.refused(2, "locate", C60, ""))
        self.assertIn("SIMPLICES: the value is empty", self.refused(2, "enforce", C60, ""))

    def test_values_that_an_option_does_not_take_are_refused_in_words(self):
        for option, value, words in [
            ("--samples", "0", '"0" is no whole number from 1 to 4294967295'),
            ("--samples", "1.5", '"1.5" is no whole number from 1'),
            ("--model", "abc", '"abc" is no whole number from 0'),
            ("--model", "-1", '"-1" is no whole number from 0'),
            ("--threads", "some", '"some" is no whole number from 1 to 1024'),
            ("--progress", "foo", "foo not in {auto,never,always}"),
            ("--progress", "2", "2 not in {auto,never,always}"),
            ("--alpha", "1e400", '"1e400" is beyond the range of a double; a finite'),
            ("--alpha", "1e200", 'the square of "1e200" is beyond the range of a double; a number below'),
            ("--inverse-alpha", "-1e-200",
             'the inverse square of "-1e-200" is beyond the range of a double; a number above'),
            ("--index", "-1", '"-1" is not an index of the spectrum; it must be a whole number from 0 on'),
            ("--index", "100000", '"100000" is not an index of the spectrum; it must be a whole number '
                                  "from 0 to "),
        ]:
            with self.subTest(option=option, value=value):
                self.assertIn(f"{option}: {words}",
                              self.refused(2, "signatures", C60, f"{option}={value}"))

    def test_options_of_a_plot_need_a_plot(self):
        for option, value in [("--plot-axis", "index"), ("--plot-range", "0,1")]:
            self.assertIn(f"{option} requires --plot",
                          self.refused(2, "signatures", C60, option, value))

    def test_a_plot_is_svg_and_a_name_that_says_otherwise_is_refused(self):
        for name in ["plot.png", "plot.pdf", "plot.html"]:
            self.assertIn("must end in .svg",
                          self.refused(2, "signatures", C60, "--plot", self.folder / name))
        for name in ["plot", "plot.svg", "plot.SVG"]:
            self.done("signatures", C60, "--plot", self.folder / name)
            self.assertTrue((self.folder / name).read_text().startswith("<svg"))
        self.done("signatures", C60, "--plot", os.devnull)

    def test_table_and_plot_need_a_file_each(self):
        (self.folder / "link").symlink_to(self.folder)
        for plot, table in [("a.svg", "a.svg"), ("./a.svg", "a.svg"), ("link/a.svg", "a.svg"),
                            ("a.svg", self.folder / "a.svg")]:
            self.assertIn("the same file", self.refused(2, "signatures", EIGHT, "--plot", plot, "-o", table,
                                                        cwd=self.folder))
        self.done("signatures", EIGHT, "--plot", "./-", "-o", "-", cwd=self.folder)

    def test_an_unknown_command_is_named(self):
        self.assertIn('"no_such_command"', self.refused(2, "no_such_command", C60))

    def test_options_of_other_formats_are_refused(self):
        self.assertIn("for molecules", self.refused(2, "summary", EIGHT, "--radii", "bondi"))
        self.assertIn("for molecules", self.refused(2, "summary", EIGHT, "--waters", "keep"))
        self.assertIn("for tables", self.refused(2, "summary", C60, "--columns", "1,2"))

    def test_a_file_over_the_limit_of_the_system_is_3(self):
        output = self.folder / "filter.csv"
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1024, 1024))
        self.assertIn("filter.csv", self.refused(3, "filter", C60, "-o", output, preexec_fn=limit))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_too_little_memory_is_3_and_says_how_much_is_needed(self):
        for command in COMMANDS:
            text = self.refused(3, command, C60, *BESIDE.get(command, []), "--memory-limit", "1000")
            self.assertRegex(text, r"about .+ of memory needed, .+ of the limit of 1000 bytes")
            self.assertIn("--memory-limit", text)
        output = self.folder / "filter.csv"
        self.refused(3, "filter", C60, "-o", output, "--memory-limit", "1M")
        self.assertEqual(list(self.folder.iterdir()), [])
        for size in ["2G", "2g", "2GiB", "2000 MB", "4.5T", "3000000000", "3000000000B"]:
            self.done("summary", C60, "--memory-limit", size)

    def test_what_is_asked_of_the_shapes_needs_memory_as_well(self):
        # Wherever the limit lies below what is enough, the status is 3 and no file is left.
        points = self.file("points.csv", "".join(
            f"{i * 7919 % 10007},{i * 104729 % 10009},{i * 611953 % 10037}\n" for i in range(20000)))
        output = self.folder / "out.ply"
        for words, arguments in [
            ("the candidates for alpha", ["alpha"]),
            ("a resample", ["alpha", "--resamples", "1"]),
            ("the candidates for alpha", ["summary", "--alpha2", "auto:solid"]),
            ("what makes the classes", ["persistence", "--homology-dimension", "2", "-o", os.devnull,
                                        "--representatives", output]),
            ("locating 20000 points", ["locate", points, "--alpha2", "30000"]),
        ]:
            with self.subTest(arguments=arguments):
                command = [arguments[0], points, *arguments[1:], "--threads", "1", "--quiet"]
                refused, low, high = set(), 16, 256
                while high - low > 1:
                    limit = (low + high) // 2
                    result = orthoball(*command, "--memory-limit", f"{limit}M")
                    if result.returncode == 0:
                        high = limit
                        output.unlink(missing_ok=True)
                    else:
                        low = limit
                        self.assertEqual((result.returncode, result.stdout), (3, ""))
                        refused.add(result.stderr.split(": about ")[0].split(": ")[-1])
                        self.assertEqual(list(self.folder.iterdir()), [points])
                self.assertLess(high, 256)
                self.assertIn(words, refused)

    def test_memory_that_the_system_refuses_is_3(self):
        points = self.file("points.csv", "".join(f"{i},{i * i % 1009},{i * i % 10007}\n"
                                                 for i in range(120000)))
        # More than the program itself takes, less than the points do.
        def limited():
            size = 100 << 20
            resource.setrlimit(resource.RLIMIT_AS, (size, size))

        if orthoball("--version", preexec_fn=limited).returncode != 0:
            self.skipTest("a sanitizer needs more addresses")
        self.assertIn("limit of the address space", self.refused(3, "summary", points,
                                                                 preexec_fn=limited))
        text = self.refused(3, "summary", points, "--memory-limit", "8G", preexec_fn=limited)
        self.assertRegex(text, r"points.csv: out of memory during \w+")

    def test_bad_data_is_1_and_names_file_and_line(self):
        path = self.file("points.csv", "x,y,z\n1,2,3\n1,two,3\n")
        self.assertIn(f"{path}:3: ", self.refused(1, "summary", path))
        self.assertIn(str(self.folder / "none.csv"), self.refused(1, "summary", self.folder / "none.csv"))
        empty = self.file("empty.csv", "x,y,z\n")
        self.assertIn(str(empty), self.refused(1, "summary", empty))

    def test_output_that_cannot_be_written_is_3(self):
        for output in ["/dev/full", self.folder / "none" / "table.csv", self.folder]:
            with self.subTest(output=output):
                self.assertIn(str(output), self.refused(3, "filter", C60, "-o", output))

    def test_standard_output_that_is_full_or_closed_is_3(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            for arguments in [*([command, C60, *BESIDE.get(command, [])] for command in COMMANDS),
                              ["--help"]]:
                result = subprocess.run([PROGRAM, *arguments], stdout=full, stderr=subprocess.PIPE,
                                        text=True, check=False)
                self.assertEqual(result.returncode, 3, arguments)
                self.assertIn("standard output", result.stderr)

    def test_a_reader_that_needs_no_more_is_3_without_a_word(self):
        for arguments in [["filter", TORI], ["summary", EIGHT], ["measure", C60], ["alpha", TORI],
                          ["persistence", TORI], ["locate", TORI, TORI, "--alpha2", "1"],
                          ["enforce", TORI, *BESIDE["enforce"]], ["--help"]]:
            reader, writer = os.pipe()
            os.close(reader)
            result = subprocess.run([PROGRAM, *arguments], stdout=writer, stderr=subprocess.PIPE,
                                    text=True, check=False)
            os.close(writer)
            self.assertEqual((result.returncode, result.stderr), (3, ""), arguments)

    def test_help_and_version_are_data(self):
        self.assertIn("summary", self.done("--help").stdout)
        self.assertRegex(self.done("--version").stdout, r"\Aorthoball \d+\.\d+\.\d+\n\Z")
        for command in ["shape", *COMMANDS]:
            text = self.done(command, "--help").stdout
            if command != "persistence":
                self.assertIn("--alpha2", text)
            self.assertIn("Examples:", text)

    def test_help_has_lines_of_100_characters_at_most(self):
        for arguments in [[], ["shape"], ["view"], *([command] for command in COMMANDS)]:
            text = self.done(*arguments, "--help").stdout
            self.assertLessEqual(max(map(len, text.splitlines())), 100)


class Files(InAFolder):
    def test_the_picture_of_the_readme_is_what_the_program_draws(self):
        plot = self.folder / "plot.svg"
        self.done("signatures", SAMPLES / "linked_tori.csv", "-o", self.folder / "table.csv",
                  "--plot", plot)
        picture = ROOT / "docs" / "pictures" / "linked_tori.svg"
        self.assertTrue(picture.read_bytes() == plot.read_bytes(), "make docs draws it anew")

    def test_an_output_appears_whole_or_not_at_all(self):
        broken = self.file("points.csv", "x,y,z\n1,2,3\n4,5\n")
        output = self.folder / "out.csv"
        output.write_text("before")
        self.refused(1, "filter", broken, "-o", output)
        self.assertEqual(output.read_text(), "before")
        self.done("filter", C60, "-o", output)
        self.assertTrue(output.read_text().startswith("position,"))
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["out.csv", "points.csv"])

    @unittest.skipUnless(MALFORMED.is_dir(), "no ../shared/data/malformed beside the source tree")
    def test_broken_inputs_leave_no_file(self):
        for name in ["nan_coord.pdb", "ragged.csv", "ply_no_xyz.ply", "gzip_truncated.pdb.gz"]:
            self.refused(1, "shape", MALFORMED / name, "-o", self.folder / "out.ply")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_unwritable_folder_is_said(self):
        locked = self.folder / "locked"
        locked.mkdir()
        locked.chmod(0o500)
        self.addCleanup(locked.chmod, 0o700)
        if os.access(locked, os.W_OK):
            self.skipTest("this user may write anywhere")
        self.assertIn("Permission", self.refused(3, "filter", C60, "-o", locked / "out.csv"))

    def test_a_file_has_the_permissions_of_others(self):
        output = self.folder / "out.csv"
        self.done("filter", C60, "-o", output, umask=0o022)
        self.assertEqual(output.stat().st_mode & 0o777, 0o644)

    def test_a_file_that_is_replaced_keeps_its_permissions(self):
        output = self.file("out.csv", "secret")
        for mode in [0o600, 0o640, 0o444]:
            output.chmod(mode)
            self.done("filter", C60, "-o", output, umask=0o022)
            self.assertEqual(output.stat().st_mode & 0o777, mode)
        self.assertTrue(output.read_text().startswith("position,"))
        output.chmod(0o6755)
        self.done("filter", C60, "-o", output, umask=0o022)
        self.assertEqual(output.stat().st_mode & 0o7777, 0o755)

    def test_a_file_that_is_replaced_keeps_its_group(self):
        output = self.file("out.csv", "secret")
        group = next((group for group in [1, *os.getgroups()] if group != output.stat().st_gid), None)
        try:
            os.chown(output, -1, group)
        except (PermissionError, TypeError):
            self.skipTest("this user has one group")
        output.chmod(0o660)
        self.done("filter", C60, "-o", output)
        self.assertEqual((output.stat().st_gid, output.stat().st_mode & 0o7777), (group, 0o660))

    @unittest.skipUnless(os.getuid() == 0, "needs two users")
    def test_a_group_that_cannot_be_kept_is_not_replaced_by_another(self):
        # The other user may have no way to where this source tree is.
        program = shutil.copy(PROGRAM, self.folder)
        os.chown(self.folder, 65534, 65534)
        for mode, kept in [(0o660, 0o600), (0o664, 0o644), (0o640, 0o600)]:
            output = self.file("out.csv", "secret")
            os.chown(output, 65534, 1)
            output.chmod(mode)
            with open(C60, encoding="utf-8") as sample:
                subprocess.run([program, "filter", "-", "--input-format", "xyz", "-o", output],
                               stdin=sample, cwd=self.folder, check=True, user=65534, group=65534,
                               extra_groups=[])
            self.assertEqual((output.stat().st_gid, output.stat().st_mode & 0o7777), (65534, kept))

    def interrupted(self, number, **options):
        """Status of a program that gets a signal while it writes, and what it leaves."""
        points = "".join(f"{i * 7919 % 10007} {i * 104729 % 10009} {i * 611953 % 10037}\n"
                         for i in range(60000))
        with subprocess.Popen([PROGRAM, "filter", self.file("points.txt", points), "-o",
                               self.folder / "out.csv"], **options) as process:
            while process.poll() is None and len(list(self.folder.iterdir())) == 1:
                time.sleep(0.001)
            process.send_signal(number)
            process.wait()
        return process.returncode, sorted(path.name for path in self.folder.iterdir())

    def test_an_output_that_is_the_input_is_refused(self):
        points = self.file("points.txt", "0 0\n1 0\n0 1\n")
        (self.folder / "link.svg").symlink_to(points)
        for arguments in [["filter", points, "-o", points], ["summary", points, "-o", points],
                          ["signatures", points, "-o", self.folder / ".." / self.folder.name / "points.txt"],
                          ["signatures", points, "--plot", self.folder / "link.svg"],
                          ["shape", points, "-o", points, "--format", "ply"],
                          ["alpha", points, "-o", points],
                          ["persistence", points, "-o", points],
                          ["persistence", points, "--plot", self.folder / "link.svg"],
                          ["locate", points, C60, "-o", points],
                          ["enforce", points, *BESIDE["enforce"], "-o", points],
                          ["filter", self.folder / "link.svg", "-o", points, "--input-format", "table"]]:
            self.assertIn("is the input", self.refused(2, *arguments))
        self.assertEqual(points.read_text(), "0 0\n1 0\n0 1\n")

    def test_a_file_of_that_name_is_not_standard_input_or_output(self):
        self.file("-", "0 0\n1 0\n0 1\n")
        self.assertTrue(self.done("filter", "./-", "--input-format", "table", "-o", "-",
                                  cwd=self.folder).stdout.startswith("position,"))
        self.done("filter", "-", "--input-format", "table", "-o", "./-", cwd=self.folder, input="0 0\n")
        self.assertTrue((self.folder / "-").read_text().startswith("position,"))

    def test_an_output_that_holds_the_radii_is_refused(self):
        radii = self.file("radii.txt", "C 1.7\n")
        self.assertIn("holds the radii", self.refused(2, "filter", C60, "--radii", radii, "-o", radii))
        self.assertIn("holds the radii", self.refused(2, "signatures", C60, "--radii", "radii.txt", "--plot",
                                                      "./radii.txt", cwd=self.folder))
        self.assertEqual(radii.read_text(), "C 1.7\n")
        self.file("bondi", "before")
        self.done("filter", C60, "--radii", "bondi", "-o", "bondi", cwd=self.folder)

    def test_a_signal_leaves_no_unfinished_file(self):
        no_core = lambda: resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        for number in [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGXCPU]:
            self.assertEqual(self.interrupted(number, preexec_fn=no_core), (-number, ["points.txt"]))

    def test_a_signal_that_is_ignored_stays_ignored(self):
        ignore = lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)
        self.assertEqual(self.interrupted(signal.SIGHUP, preexec_fn=ignore),
                         (0, ["out.csv", "points.txt"]))

    def test_standard_input_is_read(self):
        text = pathlib.Path(TWO_BALLS).read_text()
        result = self.done("filter", "-", "--input-format", "xyzr", input=text)
        self.assertEqual(result.stdout, self.done("filter", TWO_BALLS).stdout)

    def test_names_with_odd_characters_are_kept(self):
        path = self.folder / "a \"b\" é\n.xyzr"
        path.write_text(pathlib.Path(TWO_BALLS).read_text())
        summary = json.loads(self.done("summary", path, "--json").stdout)
        self.assertEqual(summary["input"]["file"], str(path))

    def test_a_name_that_is_not_utf8_gives_xml_all_the_same(self):
        path = os.path.join(os.fsencode(self.folder), b"bad\xff <name>.csv")
        with open(path, "wb") as file:
            file.write(pathlib.Path(EIGHT).read_bytes())
        plot = self.folder / "plot.svg"
        result = subprocess.run([PROGRAM, "signatures", path, "-o", os.devnull, "--plot", plot],
                                check=False)
        self.assertEqual(result.returncode, 0)
        title = xml.etree.ElementTree.parse(plot).getroot()[0]
        self.assertEqual(title.text, "Signatures of bad\ufffd <name>.csv")


class Streams(InAFolder):
    def test_words_go_to_standard_error_and_quiet_silences_them(self):
        self.assertIn("radii: bondi", self.done("filter", C60).stderr)
        self.assertEqual(self.done("filter", C60, "--quiet").stderr, "")
        self.assertEqual(self.done("summary", C60).stderr, "")

    def test_results_do_not_depend_on_threads(self):
        for command in COMMANDS:
            arguments = [command, C60, *BESIDE.get(command, [])]
            one = self.done(*arguments, "--threads", "1").stdout
            self.assertEqual(self.done(*arguments, "--threads", "3").stdout, one)
            self.assertEqual(self.done(*arguments).stdout, one)

    def test_results_do_not_depend_on_what_was_in_memory(self):
        for command in COMMANDS:
            arguments = [command, C60, *BESIDE.get(command, [])]
            # glibc fills what is allocated with the inverse of this byte.
            filled = [self.done(*arguments, env={**os.environ, "MALLOC_PERTURB_": byte}).stdout
                      for byte in ["1", "85", "255"]]
            self.assertEqual(filled, 3 * [self.done(*arguments).stdout])

    def on_a_terminal(self, *arguments, pause=0.0):
        """What is drawn on a terminal by a program whose input comes after a pause."""
        terminal, inside = pty.openpty()
        with subprocess.Popen([PROGRAM, *map(str, arguments)], stdin=subprocess.PIPE,
                              stdout=subprocess.DEVNULL, stderr=inside) as process:
            os.close(inside)
            time.sleep(pause)
            process.stdin.write(b"0 0 0\n1 0 0\n0 1 0\n")
            process.stdin.close()
            text = b""
            while True:
                try:
                    text += os.read(terminal, 4096)
                except OSError:  # the program has gone
                    break
        os.close(terminal)
        self.assertEqual(process.returncode, 0)
        return text.decode()

    def test_progress_is_drawn_on_a_terminal_when_work_takes_longer_than_a_second(self):
        table = ["filter", "-", "--input-format", "table"]
        self.assertEqual(self.on_a_terminal(*table), "")
        drawn = self.on_a_terminal(*table, pause=1.6)
        self.assertTrue(drawn.startswith("\r\033[Kreading"), drawn)
        self.assertTrue(drawn.endswith("\r\033[K"), drawn)
        self.assertEqual(self.on_a_terminal(*table, "--progress", "never", pause=1.2), "")
        self.assertEqual(self.on_a_terminal(*table, "--quiet", pause=1.2), "")

    def test_progress_tells_the_stages(self):
        stages = self.done("signatures", C60, "--progress", "always").stderr
        for stage in ["reading", "triangulation", "filtration", "signatures"]:
            self.assertRegex(stages, rf"orthoball: {stage}: \d+\.\d\d s\n")
        self.assertNotIn(" s\n", self.done("signatures", C60).stderr)

    def test_numbers_beyond_the_double_range_are_null_or_empty_with_one_warning(self):
        path = self.file("huge.csv", "x,y,z\n0,0,0\n1e200,0,0\n0,1e200,0\n0,0,1e200\n")
        result = self.done("signatures", path, "--json")
        self.assertIsNone(json.loads(result.stdout)[-1]["volume"])
        self.assertEqual(result.stderr.count("warning"), 1)
        result = self.done("signatures", path)
        row = list(csv.DictReader(io.StringIO(result.stdout)))[-1]
        self.assertEqual(row["volume"], "")
        self.assertEqual(result.stderr.count("warning"), 1)


class EmptyComplex(InAFolder):
    """Index 0 has no alpha, which is no number beyond the range of a double."""

    def said(self, *arguments):
        result = self.done(*arguments)
        self.assertNotIn("warning: 2 numbers", result.stderr)
        self.assertNotRegex(result.stdout + result.stderr, r"beyond|\binf\b|nan")
        return result

    def test_has_no_alpha_in_tables(self):
        entry = json.loads(self.said("signatures", EIGHT, "--index", "0", "--json").stdout)[0]
        self.assertEqual((entry["index"], entry["alpha2"], entry["alpha"]), (0, None, None))
        row = next(csv.DictReader(io.StringIO(
            self.said("signatures", EIGHT, "--index", "0").stdout)))
        self.assertEqual((row["index"], row["alpha2"], row["alpha"]), ("0", "", ""))
        at = json.loads(self.said("summary", EIGHT, "--index", "0", "--json").stdout)["at"][0]
        self.assertEqual((at["index"], at["alpha2"], at["alpha"]), (0, None, None))

    def test_is_called_by_its_name(self):
        self.assertIn("\nat index 0, the empty complex\n",
                      self.said("summary", EIGHT, "--index", "0").stdout)
        for ending, words in [("svg", b"<title>Alpha shape at index 0, the empty complex</title>"),
                              ("ply", b"comment boundary of the alpha shape at index 0, the empty complex\n"),
                              ("geojson", b"[\n]"), ("vtu", b""), ("glb", b'"alpha2":null')]:
            output = self.folder / f"shape.{ending}"
            said = self.said("shape", EIGHT, "--index", "0", "-o", output).stderr
            self.assertIn("orthoball: index 0, the empty complex: 0 regular edges", said)
            self.assertIn(words, output.read_bytes())

    def test_holds_no_point(self):
        row = next(csv.DictReader(io.StringIO(
            self.said("locate", EIGHT, EIGHT, "--index", "0").stdout)))
        self.assertEqual((row["inside"], row["region"], row["distance"], row["nearest"]),
                         ("0", "", "", ""))
        self.assertIn("index 0, the empty complex",
                      self.said("locate", EIGHT, EIGHT, "--index", "0").stderr)

    def test_is_not_taken_for_an_alpha2_below_the_double_range(self):
        path = self.file("huge.xyzr", "0 0 0 1e200\n3e200 0 0 1\n0 0 1 1\n")
        words = "alpha2 beyond double range"
        self.assertIn(f"\nat {words}, alpha beyond double range, index 1\n  betti          1 component",
                      self.done("summary", path, "--index", "1").stdout)
        ply = self.folder / "shape.ply"
        self.assertIn("1 singular vertex", self.done("shape", path, "--index", "1", "-o", ply).stderr)
        self.assertIn(f"at {words}, index 1\n".encode(), ply.read_bytes())
        for command in ["summary", "signatures"]:
            empty, first = [self.done(command, path, "--index", index, "--json").stderr
                            for index in ("0", "1")]
            count = lambda said: int((re.search(r"warning: (\d+) number", said) or [0, 0])[1])
            self.assertEqual(count(first) - count(empty), 2)

    def test_keeps_an_alpha2_that_was_asked_for(self):
        self.assertIn("\nat alpha2 -5, alpha -2.23606797749979, index 0\n",
                      self.said("summary", EIGHT, "--alpha2=-5").stdout)


if __name__ == "__main__":
    unittest.main()
