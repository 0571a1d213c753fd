package frustum.referee

import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.{Files, Path, Paths}
import scala.collection.mutable
import scala.jdk.CollectionConverters._
import scala.tools.asm.{ClassReader, ClassVisitor, MethodVisitor, Opcodes}

/** A referee that is fed by the code it judges cannot see that code's faults. */
class IndependenceTest extends AnyFunSuite {

  /** The input as it was read, the names of its options, and the way to run a C program. */
  private val allowed = Seq(
    "frustum.driver.scene.{Camera, Material, Scene}",
    "frustum.driver.scene.{Material, MeshVertex, TextureImage}",
    "frustum.driver.scene.{MeshVertex, TextureImage}",
    "frustum.driver.scene.TextureImage",
    "frustum.scene.VoxelWorld",
    "frustum.contract.raster.Wrap",
    "frustum.contract.raster.Combine",
    "frustum.contract.raster.{Combine, Wrap}",
    "frustum.reference.raster.MesaProgram",
    "frustum.driver.linear.Vector3",
    "java.util.Locale"
  )

  private def sources(folder: String): Seq[Path] = {
    val files = Files.list(Paths.get(s"sim/src/main/scala/frustum/$folder")).iterator.asScala.toSeq
    assert(files.nonEmpty, folder)
    files
  }

  test("the referee imports the input and nothing of the driver, the models or the references") {
    for (file <- sources("referee"); line <- Files.readAllLines(file).asScala.map(_.trim)) {
      val what = line.stripPrefix("import ")
      if (line.startsWith("import frustum") || line.startsWith("import org") || line.startsWith("import java"))
        assert(allowed.contains(what), s"$file: $line")
      // Neither by a full name, nor the scene's own arithmetic; of the driver's algebra the type of the input alone.
      val named = what.stripPrefix("frustum.driver.linear.Vector3")
      assert(
        !named.matches(".*frustum\\.(driver\\.(raster|voxel|linear)|model|engine|judge|fit|budgets|charts|command).*"),
        s"$file: $line"
      )
      assert(!what.matches(".*(Matrix4|boundingSphere|faceNormal|size\\.address).*"), s"$file: $line")
    }
  }

  /** Methods of classes that begin with `owner` which the compiled code of a folder calls. */
  private def calls(folder: String, owner: String): Set[String] = {
    val found = mutable.Set.empty[String]
    val compiled =
      Paths.get(classOf[Vec].getProtectionDomain.getCodeSource.getLocation.toURI).resolve(s"frustum/$folder")
    val method = new MethodVisitor(Opcodes.ASM9) {
      override def visitMethodInsn(op: Int, of: String, name: String, signature: String, own: Boolean): Unit =
        if (of.startsWith(owner)) found += name
    }
    val visitor = new ClassVisitor(Opcodes.ASM9) {
      override def visitMethod(a: Int, name: String, d: String, s: String, e: Array[String]): MethodVisitor = method
    }
    for (file <- Files.list(compiled).iterator.asScala if file.toString.endsWith(".class"))
      new ClassReader(Files.readAllBytes(file)).accept(visitor, 0)
    found.toSet
  }

  test("of the input's vectors the referee takes the coordinates, and nothing of their arithmetic") {
    assert(calls("referee", "frustum/driver/linear/") == Set("x", "y", "z"))
  }

  test("the references of rays and voxels import nothing of the driver or the models but what was asked for") {
    for (
      folder <- Seq("reference/ray", "reference/voxel"); file <- sources(folder);
      line <- Files.readAllLines(file).asScala if line.trim != "import frustum.driver.voxel.VoxelView"
    )
      assert(!line.matches(".*frustum\\.(driver|model|engine).*"), s"$file: $line")
  }

  test("of a view the reference takes what the user gave, and nothing that the driver made of it") {
    assert(calls("reference/voxel", "frustum/driver/") == Set("eye", "yaw", "pitch", "focal", "asked"))
  }
}
