package frustum.boards

import java.nio.file.{Files, Paths}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.SpinalConfig

class ReuseExampleTest extends AnyFunSuite {
  test("the example of docs/reuse.md elaborates, and the page quotes it as it is") {
    val directory = Files.createTempDirectory("reuse")
    SpinalConfig(targetDirectory = directory.toString, verbose = false).generateVerilog(ColorScreen(25000000))
    val source = Files.readString(Paths.get("sim/src/test/scala/frustum/boards/ReuseExample.scala"))
    val quoted = source.substring(source.indexOf("import frustum.contract.raster")).trim
    assert(Files.readString(Paths.get("docs/reuse.md")).contains(quoted))
  }
}
