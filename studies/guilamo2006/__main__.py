"""`python -m studies.guilamo2006 [--quick] [--out DIR]`: all tables and figures of the study."""

from studies.guilamo2006.run import main

if __name__ == "__main__":
    main()
