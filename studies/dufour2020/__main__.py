"""`python -m studies.dufour2020 [--quick] [--out DIR]`: all tables and figures of the study."""

from studies.dufour2020.run import main

if __name__ == "__main__":
    main()
