fn main() -> Result<(), tilesat_tools::build::Failed> {
    tilesat_tools::build::levels("levels")
}
