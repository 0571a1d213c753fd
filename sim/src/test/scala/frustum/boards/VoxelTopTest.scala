package frustum.boards

import frustum.boards.arty.{ArtyTops, VoxelTop}
import frustum.contract.voxel.WorldSize
import frustum.device.Tech
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.internals.AssignmentStatement
import java.nio.file.Files
import scala.collection.mutable

/** The Arty's voxel tops as they are built. */
class VoxelTopTest extends AnyFunSuite {

  /** Registers that a pin reaches without another one between, by the name of the component that they are in. */
  private def firstRegisters(top: Component, pin: BaseType): Set[String] = {
    val loads = mutable.Map.empty[BaseType, Set[BaseType]].withDefaultValue(Set.empty)
    top.walkComponents(_.dslBody.walkStatements {
      case a: AssignmentStatement =>
        val target = a.finalTarget
        a.walkDrivingExpressions { case b: BaseType => loads(b) += target; case _ => }
        var scope = a.parentScope.parentStatement
        while (scope != null) { // what a condition decides on
          scope.walkDrivingExpressions { case b: BaseType => loads(b) += target; case _ => }
          scope = scope.parentScope.parentStatement
        }
      case _ =>
    })
    val seen = mutable.Set.empty[BaseType]
    val found = mutable.Set.empty[String]
    def follow(from: BaseType): Unit = for (to <- loads(from) if seen.add(to))
      if (to.isReg) found += to.component.getClass.getSimpleName else follow(to)
    follow(pin)
    found.toSet
  }

  test("the serial line and the pad's answer reach nothing but synchronisers") {
    val size = WorldSize(8, 8, 8)
    val large = ArtyTops.voxelConfig
    val small = large.copy(voxel = large.voxel.copy(size = size), rules = large.rules.copy(size = size))
    val top = SpinalConfig(targetDirectory = Files.createTempDirectory("voxel-top").toString)
      .generateVerilog(VoxelTop(small, Tech.Generic)).toplevel
    for (pin <- Seq(top.io.uart, top.io.pad_dat)) assert(firstRegisters(top, pin) == Set("BufferCC"), pin)
  }

  test("what a part's block RAMs cannot hold is refused, with figures") {
    val refusal = intercept[IllegalArgumentException](
      ArtyTops.voxelTop("arty-voxel-35t", Part.Artix7A35, ArtyTops.voxelConfig).component(Tech.Artix7)
    )
    assert(refusal.getMessage.contains("XC7A35T") && refusal.getMessage.contains("kbit"), refusal.getMessage)
  }
}
