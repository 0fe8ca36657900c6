"""Command-line programs of this repository, run within the process of a test: starting them a hundred times takes long."""
import contextlib
import io
import os


def run(main, folder, arguments):
    """(exit code, output, errors) of main(arguments) in `folder`."""
    output, errors, before = io.StringIO(), io.StringIO(), os.getcwd()
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
            code = main([str(argument) for argument in arguments])
    finally:
        os.chdir(before)
    return code, output.getvalue(), errors.getvalue()
